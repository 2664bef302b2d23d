/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>

#include <algorithm>
#include <optional>
#include <thread>

namespace psmks
{
namespace
{
bool isIdentical(const std::optional<Ambiguity>& a, const std::optional<Ambiguity>& b)
{
  if (!a || !b) return !a && !b;
  return a->alternatives == b->alternatives &&
         std::equal(a->likeliest.begin(), a->likeliest.end(), b->likeliest.begin(),
                    [](const Ambiguity::Alternative& x, const Ambiguity::Alternative& y)
                    { return x.weight == y.weight && isNearly(x.T_ref_cur, y.T_ref_cur, 0, 0); });
}

/** Whether two results are equal to the last bit, except for their times. */
testing::AssertionResult isIdentical(const MatchResult& a, const MatchResult& b)
{
  const bool same = a.status == b.status && a.T_ref_cur.x_m == b.T_ref_cur.x_m &&
                    a.T_ref_cur.y_m == b.T_ref_cur.y_m &&
                    a.T_ref_cur.phi_rad == b.T_ref_cur.phi_rad && a.covariance == b.covariance &&
                    a.score == b.score && a.errorBefore == b.errorBefore &&
                    a.errorAfter == b.errorAfter && a.associations == b.associations &&
                    a.iterations == b.iterations && a.hypotheses == b.hypotheses &&
                    a.unobservableDirection == b.unobservableDirection &&
                    a.weakDirection == b.weakDirection && isIdentical(a.ambiguity, b.ambiguity);
  if (same) return testing::AssertionSuccess();
  return testing::AssertionFailure() << a.report() << "\nis not " << b.report();
}

class Repeat : public SchemeLaw
{
 protected:
  /** Half of the pairs are too far apart for the first starting pose, so that the search is used as
   * well. */
  std::vector<ScanPair> somePairs()
  {
    std::vector<ScanPair> pairs;
    for (int i = 0; i < kPairs; ++i)
    {
      ScanPair pair = randomPair(i % 3 ? kHalfCircle : kFullCircle);
      if (i % 2 && !pairs.empty() && pairs.back().current.grid == pair.current.grid)
        pair.current = pairs.back().current;
      pairs.push_back(pair);
    }
    return pairs;
  }

  std::vector<MatchResult> matchAll(const std::vector<ScanPair>& pairs,
                                    MatcherWorkspace& workspace) const
  {
    std::vector<MatchResult> results;
    for (const ScanPair& pair : pairs)
      results.push_back(matcher_.match(pair.reference, pair.current, {}, workspace));
    return results;
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, Repeat, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST_P(Repeat, AUsedWorkspaceGivesTheSameAsAFreshOne)
{
  const std::vector<ScanPair> pairs = somePairs();
  const std::vector<MatchResult> first = matchAll(pairs, workspace_);
  const std::vector<MatchResult> again = matchAll(pairs, workspace_);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    MatcherWorkspace fresh;
    EXPECT_TRUE(isIdentical(again[i], first[i])) << "pair " << i;
    EXPECT_TRUE(
        isIdentical(matcher_.match(pairs[i].reference, pairs[i].current, {}, fresh), first[i]))
        << "pair " << i;
  }
}

TEST_P(Repeat, TwoThreadsWithTheirOwnWorkspacesGiveTheSameAsOne)
{
  const std::vector<ScanPair> pairs = somePairs();
  const std::vector<MatchResult> sequential = matchAll(pairs, workspace_);
  std::vector<MatchResult> results[2];
  std::vector<std::thread> threads;
  for (std::vector<MatchResult>& result : results)
    threads.emplace_back(
        [&]
        {
          MatcherWorkspace workspace;
          result = matchAll(pairs, workspace);
        });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<MatchResult>& result : results)
    for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_TRUE(isIdentical(result[i], sequential[i])) << "pair " << i;
}
}  // namespace psmks
