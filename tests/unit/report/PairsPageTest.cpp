/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/PairsPage.h>
#include <gtest/gtest.h>
#include <tests/unit/report/Markup.h>
#include <tests/unit/report/ScanPairs.h>

namespace psmks
{
namespace
{
using test::countOf;

/** Twelve pairs. The error of pair i is i mm, so that the pairs 2 to 11 are the worst ten. */
PairsSetResult dozen(const std::string& title)
{
  PairsSetResult set;
  set.title = title;
  PairsRun run{"a", "zero", {}};
  for (int id = 0; id < 12; ++id)
  {
    set.pairs.push_back(test::forkPair(id));
    run.records.push_back(test::matched(id, 1e-3 * id));
  }
  set.bounds.resize(set.pairs.size());
  set.runs = {run};
  return set;
}
}  // namespace

TEST(PairsPage, DrawsTheWorstTenOfEachRun)
{
  const std::string html = pairsPage({"machine", "command"}, {}, {dozen("plain")});
  EXPECT_EQ(test::firstFlaw(html), "");
  EXPECT_EQ(countOf("<figure>", html), 10);
  EXPECT_EQ(countOf("<figcaption>pair 11: 11.0 mm", html), 1);
  EXPECT_EQ(countOf("<figcaption>pair 2: 2.0 mm", html), 1);
  EXPECT_EQ(countOf("<figcaption>pair 1: ", html), 0);
  EXPECT_EQ(countOf(" id=", html), 2 * 10);
}

TEST(PairsPage, SetsDoNotShareOutlines)
{
  const std::string html = pairsPage({"machine", "command"}, {}, {dozen("a < b"), dozen("c & d")});
  EXPECT_EQ(test::firstFlaw(html), "");
  EXPECT_EQ(countOf("id=\"set0-11-current\"", html), 1);
  EXPECT_EQ(countOf("id=\"set1-11-current\"", html), 1);
  EXPECT_NE(html.find("<h2>a &lt; b, guess: zero</h2>"), std::string::npos);
}
}  // namespace psmks
