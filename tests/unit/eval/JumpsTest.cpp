/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Jumps.h>

namespace psmks
{
namespace
{
/** A path of five poses, half a metre ahead each second.
 *
 *     o--o--o--o--o */
Trajectory straight()
{
  Trajectory trajectory;
  for (int i = 0; i < 5; ++i) trajectory.push_back({100.0 + i, {0.5 * i, 0, 0}});
  return trajectory;
}

/** The same path with the pose in the middle moved to the left. */
Trajectory withMiddleMoved(double left_m, double turned_deg = 0)
{
  Trajectory trajectory = straight();
  trajectory[2].pose.y_m += left_m;
  trajectory[2].pose.phi_rad += degToRad(turned_deg);
  return trajectory;
}
}  // namespace

TEST(Jumps, AStraightPathHasNone)
{
  EXPECT_EQ(countJumps(straight(), straight(), trueSteps(straight(), straight())), 0);
}

//        o
//      /   \.
//  o--o     o--o
TEST(Jumps, APoseBesideThePathIsAJumpThereAndOneBack)
{
  const auto truth = trueSteps(straight(), straight());
  EXPECT_EQ(countJumps(withMiddleMoved(0.4), straight(), truth), 2);
  EXPECT_EQ(countJumps(withMiddleMoved(0.2), straight(), truth), 0) << "below the limit";
}

TEST(Jumps, ATurnedPoseJumpsToo)
{
  const auto truth = trueSteps(straight(), straight());
  EXPECT_EQ(countJumps(withMiddleMoved(0, 11), straight(), truth), 2);
  EXPECT_EQ(countJumps(withMiddleMoved(0, 9), straight(), truth), 0);
}

TEST(Jumps, WhereTheWheelsWereWrongTheEstimateDidNotJump)
{
  const auto truth = trueSteps(straight(), straight());
  EXPECT_EQ(countJumps(withMiddleMoved(0.4), withMiddleMoved(0.4), truth), 0);
  EXPECT_EQ(countJumps(straight(), withMiddleMoved(0.4), truth), 0);
}

TEST(Jumps, OnlyKnownMotionsCount)
{
  const std::vector<Relation> one{{101, 102, {0.5, 0, 0}}, {102, 300, {0, 0, 0}}};
  EXPECT_EQ(countJumps(withMiddleMoved(0.4), straight(), one), 1);
}

TEST(TrueSteps, LeaveOutWhatTheTruthDoesNotCover)
{
  Trajectory truth = straight();
  truth.pop_back();
  const auto steps = trueSteps(withMiddleMoved(0.4), truth);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[1].from_s, 101);
  EXPECT_EQ(steps[1].to_s, 102);
  EXPECT_NEAR(steps[1].T_from_to.x_m, 0.5, 1e-12);
  EXPECT_NEAR(steps[1].T_from_to.y_m, 0, 1e-12);
}
}  // namespace psmks
