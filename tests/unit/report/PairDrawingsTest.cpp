/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/PairDrawings.h>
#include <gtest/gtest.h>
#include <tests/unit/report/Markup.h>
#include <tests/unit/report/ScanPairs.h>

#include <regex>

namespace psmks
{
using test::countOf;
using test::forkPair;
using test::matched;

TEST(PairDrawings, ShowWhereTheScanWasAndWhereItWasPut)
{
  const std::vector<ScanPair> pairs{forkPair(7)};
  PairDrawings drawings("set", pairs);
  const std::string figure = drawings.draw(0, matched(7, 0.25, 10));
  EXPECT_EQ(test::firstFlaw(figure), "");
  const std::string current = "<use href=\"#set-0-current\" class=";
  EXPECT_NE(figure.find(current + "\"truth\" transform=\"translate(0.0,-100.0) rotate(-0.000)\"/>"),
            std::string::npos)
      << figure;
  EXPECT_NE(
      figure.find(current + "\"estimate\" transform=\"translate(0.0,-75.0) rotate(-10.000)\"/>"),
      std::string::npos)
      << figure;
  EXPECT_NE(figure.find("<figcaption>pair 7: 250.0 mm, 10.000 deg, Converged</figcaption>"),
            std::string::npos)
      << figure;
}

TEST(PairDrawings, AScanThatIsShownTwiceIsOutlinedOnce)
{
  const std::vector<ScanPair> pairs{forkPair(0), forkPair(1), forkPair(2)};
  PairDrawings drawings("set", pairs);
  const std::string figures = drawings.draw(2, matched(2, 0.1)) +
                              drawings.draw(0, matched(0, 0.1)) + drawings.draw(2, matched(2, 0.2));
  const std::string outlines = drawings.outlines();
  EXPECT_EQ(test::firstFlaw(outlines), "");
  EXPECT_EQ(countOf(" id=", outlines), 4);

  const std::regex use("href=\"#([^\"]+)\"");
  for (std::sregex_iterator i(figures.begin(), figures.end(), use), none; i != none; ++i)
    EXPECT_EQ(countOf(" id=\"" + (*i)[1].str() + '"', outlines), 1) << (*i)[1];
}
}  // namespace psmks
