/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Pose2.h>
#include <tests/support/RandomNumbers.h>

namespace psmks
{
namespace
{
Pose2 randomPose(test::RandomNumbers& random)
{
  return {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-kPi, kPi)};
}

void expectNear(const Pose2& pose, const Pose2& expected, double tolerance)
{
  EXPECT_NEAR(pose.x_m, expected.x_m, tolerance);
  EXPECT_NEAR(pose.y_m, expected.y_m, tolerance);
  EXPECT_NEAR(wrapAngle(pose.phi_rad - expected.phi_rad), 0, tolerance);
}
}  // namespace

// A robot at (2, 1) that looks along +y sees a point 3 m ahead and 1 m to its left:
//
//   y
//   4    P . .      P = (1, 4)
//   3        ^
//   2        |
//   1        R      R = (2, 1), 90 degrees
//     0  1   2  x
TEST(Pose2, MapsAPointOfTheInnerFrameIntoTheOuterOne)
{
  const Pose2 T_world_robot{2, 1, degToRad(90)};
  const Eigen::Vector2d p_world = T_world_robot * Eigen::Vector2d(3, 1);
  EXPECT_NEAR(p_world.x(), 1, 1e-15);
  EXPECT_NEAR(p_world.y(), 4, 1e-15);
}

TEST(Pose2, CompositionMapsPointsAsOneMotionAfterTheOther)
{
  test::RandomNumbers random(21);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 100; ++n)
  {
    const Pose2 T_a_b = randomPose(random), T_b_c = randomPose(random);
    const Eigen::Vector2d p_c(random.uniform(-5, 5), random.uniform(-5, 5));
    EXPECT_NEAR(((T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c)).norm(), 0, 1e-12);
  }
}

TEST(Pose2, APoseTimesItsInverseIsTheIdentity)
{
  test::RandomNumbers random(22);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 100; ++n)
  {
    const Pose2 T_a_b = randomPose(random);
    expectNear(T_a_b * T_a_b.inverse(), Pose2{}, 1e-12);
    expectNear(T_a_b.inverse() * T_a_b, Pose2{}, 1e-12);
  }
}

TEST(Pose2, TheHeadingIsWrappedByEveryOperation)
{
  const Pose2 turned{0, 0, degToRad(170)};
  EXPECT_NEAR((turned * turned).phi_rad, degToRad(-20), 1e-12);
  EXPECT_EQ((Pose2{0, 0, kPi}.inverse().phi_rad), kPi);
}

TEST(Pose2, TheDerivativeOfTheRotationIsItsSlope)
{
  const double step_rad = 1e-6;
  for (const double phi_rad : {-3.0, -0.4, 0.0, 1.2})
  {
    const Eigen::Matrix2d slope =
        (Pose2{0, 0, phi_rad + step_rad}.rotation() - Pose2{0, 0, phi_rad - step_rad}.rotation()) /
        (2 * step_rad);
    EXPECT_TRUE((Pose2{0, 0, phi_rad}.rotationDerivative().isApprox(slope, 1e-9))) << phi_rad;
  }
}

TEST(Pose2, KnowsWhetherItIsFinite)
{
  EXPECT_TRUE((Pose2{1, 2, 3}.isFinite()));
  EXPECT_FALSE((Pose2{std::nan(""), 0, 0}.isFinite()));
  EXPECT_FALSE((Pose2{0, INFINITY, 0}.isFinite()));
  EXPECT_FALSE((Pose2{0, 0, -INFINITY}.isFinite()));
}
}  // namespace psmks
