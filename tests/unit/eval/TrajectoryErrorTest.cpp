/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/TrajectoryError.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
namespace
{
TEST(TrajectoryErrorTest, TheErrorIsMeasuredFromTheFirstCommonPose)
{
  //  truth, turned by 90 degrees and moved:  (5, 5) -> (5, 6) -> (5, 7)
  const Trajectory truth{{0, {5, 5, kPi / 2}}, {1, {5, 6, kPi / 2}}, {2, {5, 7, kPi / 2}}};
  const Trajectory estimate{{0, {0, 0, 0}}, {1, {1, 0.3, 0}}, {2, {2, 0, 0.1}}};
  const TrajectoryError error = trajectoryError(estimate, truth);
  EXPECT_EQ(error.poses, 3u);
  EXPECT_NEAR(error.mean_m, 0.1, 1e-12);
  EXPECT_NEAR(error.rms_m, 0.3 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(error.max_m, 0.3, 1e-12);
  EXPECT_NEAR(error.max_rad, 0.1, 1e-12);
  EXPECT_NEAR(error.alignedMean_m, 0.4 / 3, 1e-12) << "moved aside by 0.1 m";
}

TEST(TrajectoryErrorTest, TheTruthIsInterpolatedButNotAcrossGaps)
{
  const Trajectory truth{{0, {0, 0, 3.1}}, {1, {1, 0, -3.1}}, {9, {9, 0, -3.1}}};
  const double halfTurn = kPi;
  const Trajectory estimate{{0.5, {0.5, 0, halfTurn}}, {5, {0, 0, 0}}, {10, {0, 0, 0}}};
  const TrajectoryError error = trajectoryError(estimate, truth);
  EXPECT_EQ(error.poses, 1u);
  EXPECT_NEAR(error.max_m, 0, 1e-12);
  EXPECT_TRUE(std::isnan(trajectoryError(estimate, {}).mean_m));
}
}  // namespace
}  // namespace psmks
