/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/CommonPoses.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
/** A path of a metre a second along x, from a given time on. */
Trajectory straight(double from_s, double step_s, int poses)
{
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i)
    trajectory.push_back({from_s + i * step_s, {from_s + i * step_s, 0, 0}});
  return trajectory;
}

std::size_t countMeasured(const std::vector<CommonPose>& common)
{
  std::size_t count = 0;
  for (const auto& pose : common) count += pose.isMeasured;
  return count;
}

//  truth     o---------o---------o               o    one a second, then a gap
//  estimate  |  x   x  |x   x    |    x    x     |
TEST(CommonPosesTest, TheTruthIsInterpolatedButNotAcrossGaps)
{
  const Trajectory truth{{0, {0, 0, 3.1}}, {1, {1, 0, -3.1}}, {2, {2, 0, -3.1}}, {9, {9, 0, 0}}};
  const Trajectory estimate{{-1, {}}, {0, {}}, {0.5, {}}, {2, {}}, {5, {}}, {9, {}}, {10, {}}};
  const auto common = commonPoses(estimate, truth);
  ASSERT_EQ(common.size(), 4u);
  EXPECT_TRUE(isNearly(common[0].T_true, {0, 0, 3.1}, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(common[1].T_true, {0.5, 0, kPi}, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(common[2].T_true, {2, 0, -3.1}, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(common[3].T_true, {9, 0, 0}, 1e-12, 1e-12));
}

TEST(CommonPosesTest, ATruthAsDenseAsTheEstimateIsMeasuredEverywhere)
{
  const Trajectory estimate = straight(100, 0.1, 21);
  for (const double offset_s : {0.0, -0.05})
    for (const double step_s : {0.1, 0.01})
    {
      const auto common = commonPoses(estimate, straight(100 + offset_s, step_s, 300));
      EXPECT_EQ(common.size(), 21u);
      EXPECT_EQ(countMeasured(common), 21u) << offset_s << ' ' << step_s;
    }
}

TEST(CommonPosesTest, ASparseTruthIsMeasuredWhereItHasPoses)
{
  const auto common = commonPoses(straight(100, 0.1, 21), straight(100, 0.5, 5));
  EXPECT_EQ(common.size(), 21u);
  EXPECT_EQ(countMeasured(common), 5u);
  EXPECT_TRUE(common[5].isMeasured);
  EXPECT_FALSE(common[6].isMeasured);
}

TEST(CommonPosesTest, TheStampsOfTheEstimateMayRepeatAndGoBackwards)
{
  const Trajectory estimate{{2, {2, 0, 0}}, {1, {1, 0, 0}}, {1, {1, 0, 0}}, {3, {3, 0, 0}}};
  const auto common = commonPoses(estimate, straight(0, 1, 5));
  ASSERT_EQ(common.size(), 4u);
  EXPECT_EQ(countMeasured(common), 4u);
  for (const auto& pose : common) EXPECT_TRUE(isNearly(pose.T_true, pose.T_estimated, 1e-12, 0));
}

TEST(CommonPosesTest, ANumberedTruthGoesWithTheEstimateRowByRow)
{
  const Trajectory truth{{0, {0, 0, 0}}, {1, {10, 0, 0}}, {2, {20, 0, 0}}};
  EXPECT_TRUE(isNumbered(truth));
  const Trajectory estimate{{1e9, {0, 1, 0}}, {1e9 + 7, {10, 1, 0}}, {1e9 + 6, {20, 1, 0}}};
  const auto common = commonPoses(estimate, truth);
  ASSERT_EQ(common.size(), 3u);
  EXPECT_EQ(countMeasured(common), 3u);
  EXPECT_EQ(common[2].stamp_s, 1e9 + 6);
  EXPECT_EQ(common[2].T_true.x_m, 20);
  EXPECT_EQ(common[2].T_estimated.x_m, 20);
}

TEST(CommonPosesTest, ThePoseBeforeTheFirstActionHasNoRow)
{
  const Trajectory truth{{0, {10, 0, 0}}, {1, {20, 0, 0}}};
  const Trajectory estimate{{1e9, {0, 1, 0}}, {1e9 + 1, {10, 1, 0}}, {1e9 + 2, {20, 1, 0}}};
  const auto common = commonPoses(estimate, truth);
  ASSERT_EQ(common.size(), 2u);
  for (const auto& pose : common) EXPECT_EQ(pose.T_true.x_m, pose.T_estimated.x_m);
}

TEST(CommonPosesTest, RowsThatNobodyKnowsThePosesOfAreNotCompared)
{
  const Trajectory truth{{0, {}}, {1, {}}, {2, {}}};
  EXPECT_TRUE(commonPoses(straight(1e9, 1, 2), truth).empty());
  EXPECT_TRUE(commonPoses(straight(1e9, 1, 5), truth).empty());
}

TEST(CommonPosesTest, NumbersAreTimesWhereTheEstimateHasSuchTimes)
{
  const auto common = commonPoses(straight(0, 0.5, 5), straight(0, 1, 3));
  ASSERT_EQ(common.size(), 5u);
  EXPECT_NEAR(common[1].T_true.x_m, 0.5, 1e-12);
}

TEST(CommonPosesTest, OnlyNumbersOfRowsAreNumbers)
{
  EXPECT_FALSE(isNumbered({}));
  EXPECT_FALSE(isNumbered({{1, {}}, {2, {}}}));
  EXPECT_FALSE(isNumbered({{0, {}}, {1.5, {}}}));
  EXPECT_FALSE(isNumbered({{0, {}}, {0, {}}}));
}
}  // namespace
}  // namespace psmks
