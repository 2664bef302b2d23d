/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>
#include <tests/support/BadInput.h>

#include <Eigen/Cholesky>
#include <cstdlib>

namespace psmks
{
namespace
{
/** How many scans are tried. PSMKS_FUZZ_SCANS in the environment replaces the number: by a smaller
 * one, for sanitizers are slow, or by a million.
 */
int scansToTry()
{
  constexpr int kScans = 1000;
  const char* fewer = std::getenv("PSMKS_FUZZ_SCANS");
  return fewer ? std::atoi(fewer) : kScans;
}

class Fuzz : public SchemeLaw
{
 protected:
  SearchScope randomScope()
  {
    return random_.integer(0, 2) ? SearchScope::Full : SearchScope::WithinCovariance;
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, Fuzz, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST_P(Fuzz, BadScansNeitherThrowNorGiveNan)
{
  const int count = scansToTry();
  test::BadScans scans(random_);
  Scan reference = scans.next();
  for (int i = 0; i < count; ++i)
  {
    const Scan current = scans.next();
    const Guess guess = test::anyGuess(random_);
    const MatchResult result =
        matcher_.match(reference, current, guess, workspace_, nullptr, randomScope());
    EXPECT_NE(result.status, MatchStatus::NotRun);
    EXPECT_TRUE(result.T_ref_cur.isFinite()) << "scan " << i << ": " << result.report();
    EXPECT_TRUE(result.covariance.allFinite()) << "scan " << i << ": " << result.report();
    EXPECT_EQ(result.covariance, result.covariance.transpose()) << "scan " << i;
    EXPECT_EQ(result.covariance.llt().info(), Eigen::Success)
        << "scan " << i << ": " << result.report() << '\n'
        << result.covariance;
    EXPECT_TRUE(result.score >= 0 && result.score <= 1) << "scan " << i;
    const bool keepsGuess = !result.usable() && guess.T_ref_cur.isFinite();
    EXPECT_TRUE(!keepsGuess || isNearly(result.T_ref_cur, guess.T_ref_cur, 0, 0)) << "scan " << i;
    reference = current;
  }
}
}  // namespace psmks
