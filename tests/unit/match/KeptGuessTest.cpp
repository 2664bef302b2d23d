/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Covariance.h>
#include <psmks/match/KeptGuess.h>
#include <tests/support/PoseMatcher.h>

#include <cmath>

namespace psmks
{
namespace
{
const Eigen::Matrix3d kKnown = Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal();

TEST(KeptGuess, HasPoseAndCovarianceOfTheGuess)
{
  const MatchResult result = keptGuess(MatchStatus::NoImprovement, {{1, 2, 3}, kKnown});
  EXPECT_EQ(result.status, MatchStatus::NoImprovement);
  EXPECT_TRUE(isNearly(result.T_ref_cur, {1, 2, 3}, 0, 0));
  EXPECT_EQ(result.covariance, kKnown);
}

TEST(KeptGuess, IsTheOriginAndUnknownForAGuessThatIsNone)
{
  Eigen::Matrix3d lopsided = kKnown;
  lopsided(0, 1) = 1;
  for (const Eigen::Matrix3d& none :
       {lopsided, Eigen::Matrix3d(-kKnown), Eigen::Matrix3d::Constant(std::nan("")).eval()})
  {
    const MatchResult result = keptGuess(MatchStatus::InvalidInput, {{std::nan(""), 2, 3}, none});
    EXPECT_TRUE(isNearly(result.T_ref_cur, {}, 0, 0));
    EXPECT_EQ(result.covariance, MatchResult::unknownCovariance());
  }
}

TEST(KeptGuess, AVagueOneIsBounded)
{
  const Guess vague{{}, Eigen::Matrix3d(1e18 * Eigen::Matrix3d::Identity())};
  EXPECT_NEAR((*boundedGuess(vague).covariance)(1, 1), kVaguest, 1);
  EXPECT_NEAR(keptGuess(MatchStatus::NoImprovement, vague).covariance(1, 1), kVaguest, 1);
  EXPECT_FALSE(boundedGuess({}).covariance);
}

TEST(SettleCovariance, ReplacesWhatIsNoCovarianceByThatOfTheGuess)
{
  for (const double element : {std::nan(""), double(INFINITY), -1.0, 0.0})
  {
    MatchResult result;
    result.covariance(1, 1) = element;
    settleCovariance({{}, kKnown}, result);
    EXPECT_EQ(result.covariance, kKnown) << element;
  }
}

TEST(SettleCovariance, MakesRoundedOnesPositiveDefinite)
{
  MatchResult result;
  result.covariance = Eigen::Matrix3d::Ones();
  settleCovariance({}, result);
  EXPECT_TRUE(isCovariance(result.covariance));
  EXPECT_NEAR(result.covariance(0, 2), 1, 1e-12);
}
}  // namespace
}  // namespace psmks
