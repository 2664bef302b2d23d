/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairError.h>

#include <cmath>

namespace psmks
{
TEST(PairError, IsTheDistanceAndTheAngleBetweenTwoPoses)
{
  const PairError error = pairError({1.03, 2.04, degToRad(30)}, {1, 2, degToRad(32)});
  EXPECT_NEAR(error.translation_m, 0.05, 1e-12);
  EXPECT_NEAR(error.rotation_rad, degToRad(2), 1e-12);
}

TEST(PairError, CrossesTheHalfTurnTheShortWay)
{
  const PairError error = pairError({0, 0, degToRad(179)}, {0, 0, degToRad(-179)});
  EXPECT_NEAR(error.rotation_rad, degToRad(2), 1e-12);
}

TEST(PairError, SuccessNeedsBothTranslationAndRotation)
{
  EXPECT_TRUE(isSuccess({0.049, degToRad(0.99)}));
  EXPECT_FALSE(isSuccess({0.051, 0}));
  EXPECT_FALSE(isSuccess({0, degToRad(1.01)}));
}

TEST(PairError, AnotherLimitMovesSuccessAndWrongAlike)
{
  const PairError limit{0.15, degToRad(2)};
  EXPECT_TRUE(isSuccess({0.14, degToRad(1.9)}, limit));
  EXPECT_FALSE(isSuccess({0.16, 0}, limit));
  EXPECT_FALSE(isAcceptedAndWrong(MatchStatus::Converged, {0.29, degToRad(3.9)}, limit));
  EXPECT_TRUE(isAcceptedAndWrong(MatchStatus::Converged, {0.31, 0}, limit));
}

TEST(PairError, OnlyAConfidentStatusCanBeAcceptedAndWrong)
{
  const PairError wrong{0.11, 0};
  EXPECT_TRUE(isAcceptedAndWrong(MatchStatus::Converged, wrong));
  EXPECT_TRUE(isAcceptedAndWrong(MatchStatus::MaxIterations, {0, degToRad(2.1)}));
  EXPECT_FALSE(isAcceptedAndWrong(MatchStatus::Degenerate, wrong));
  EXPECT_FALSE(isAcceptedAndWrong(MatchStatus::TooFewAssociations, wrong));
  EXPECT_FALSE(isAcceptedAndWrong(MatchStatus::Converged, {0.099, degToRad(1.9)}));
}

// One standard deviation off in x, two in y, three in phi: 1 + 4 + 9.
TEST(Nees, SumsTheSquaredErrorsInStandardDeviations)
{
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  EXPECT_NEAR(nees({0.1, 0.4, 0.9}, covariance, {0, 0, 0}), 14, 1e-9);
}

TEST(Nees, DoesNotExistForASingularCovariance)
{
  EXPECT_TRUE(std::isnan(nees({}, Eigen::Matrix3d::Zero(), {})));
}
}  // namespace psmks
