/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Robot.h>
#include <tests/support/PoseMatcher.h>

#include <cmath>

namespace psmks
{
namespace
{
constexpr double kStep_s = 0.02;

/** A robot whose wheels reach the commanded speeds at once and have no noise. */
RobotOptions exactRobot()
{
  RobotOptions options;
  options.maxAcceleration_mps2 = 1e6;
  options.wheelNoise = 0;
  options.noiseStep_s = kStep_s;
  return options;
}

Robot driven(const RobotOptions& options, const WheelSpeeds& speeds, int steps, unsigned seed = 1)
{
  Robot robot(options, {});
  std::mt19937_64 random(seed);
  for (int step = 0; step < steps; ++step) robot.advance(speeds, random);
  return robot;
}
}  // namespace

TEST(Robot, EqualWheelsDriveStraightOn)
{
  const Robot robot = driven(exactRobot(), {0.5, 0.5}, 100);  // 2 s
  EXPECT_TRUE(isNearly(robot.T_world_robot(), {1, 0, 0}, 1e-9, 1e-9));
}

TEST(Robot, OppositeWheelsTurnItOnTheSpot)
{
  // Rims 0.2 m from the middle at 0.1 m/s: 0.5 rad/s, for 1 s.
  const Robot robot = driven(exactRobot(), {-0.1, 0.1}, 50);
  EXPECT_TRUE(isNearly(robot.T_world_robot(), {0, 0, 0.5}, 1e-9, 1e-9));
}

//        (0, 2 R)
//     .-o
//    |   ^ half a circle to the left about (0, R)
//     '->
TEST(Robot, AFasterRightWheelDrivesACircleToTheLeft)
{
  // 0.3 m/s about a centre R = 0.6 m to the left: 0.5 rad/s, half a circle in 2 pi seconds.
  RobotOptions options = exactRobot();
  options.noiseStep_s = 2 * kPi / 100;
  const Robot robot = driven(options, {0.2, 0.4}, 100);
  EXPECT_TRUE(isNearly(robot.T_world_robot(), {0, 1.2, kPi}, 1e-9, 1e-9));
}

TEST(Robot, OdometryIsTheTruthWithoutNoise)
{
  RobotOptions options;
  options.wheelNoise = 0;
  const Pose2 start{3, -2, 1};
  Robot robot(options, start);
  std::mt19937_64 random(1);
  for (int step = 0; step < 500; ++step)
    robot.advance({0.3 + 0.2 * std::sin(step * 0.05), 0.4}, random);
  EXPECT_TRUE(isNearly(robot.T_world_robot(), start * robot.T_start_odometry(), 1e-9, 1e-9));
}

// A wheel at v whose noise is U(-n, n) a step t drives v t (1 + n U(-1, 1)), with a standard
// deviation of v t n / sqrt(3) a step, and both wheels are independent.
TEST(Robot, WheelsSlipIndependentlyByTheirNoise)
{
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  constexpr int kSteps = 20000;
  RobotOptions options = exactRobot();
  options.wheelNoise = 0.05;
  Robot robot(options, {});
  std::mt19937_64 random(kSeed);
  double sum_m = 0, squares_m2 = 0, turnSquares_rad2 = 0, product = 0;
  for (int step = 0; step < kSteps; ++step)
  {
    const Pose2 before = robot.T_world_robot();
    robot.advance({0.5, 0.5}, random);
    const Pose2 moved = before.inverse() * robot.T_world_robot();
    const double error_m = moved.translation().norm() - 0.5 * kStep_s;
    ASSERT_LE(std::abs(error_m), 0.05 * 0.5 * kStep_s);
    sum_m += error_m;
    squares_m2 += error_m * error_m;
    turnSquares_rad2 += moved.phi_rad * moved.phi_rad;
    product += error_m * moved.phi_rad;
  }
  const double wheelSigma_m = 0.5 * kStep_s * 0.05 / std::sqrt(3);
  const double sigma_m = wheelSigma_m / std::sqrt(2);  // of the mean of both
  const double turnSigma_rad = wheelSigma_m * std::sqrt(2) / options.track_m;  // of the difference
  EXPECT_LT(std::abs(sum_m / kSteps), 5 * sigma_m / std::sqrt(kSteps));
  EXPECT_NEAR(std::sqrt(squares_m2 / kSteps), sigma_m, 0.05 * sigma_m);
  EXPECT_NEAR(std::sqrt(turnSquares_rad2 / kSteps), turnSigma_rad, 0.05 * turnSigma_rad);
  EXPECT_LT(std::abs(product / kSteps), 0.05 * sigma_m * turnSigma_rad);
}

TEST(Robot, TheOdometryKnowsNothingOfTheSlip)
{
  RobotOptions options = exactRobot();
  options.wheelNoise = 0.05;
  const Robot robot = driven(options, {0.5, 0.5}, 100);
  EXPECT_TRUE(isNearly(robot.T_start_odometry(), {1, 0, 0}, 1e-9, 1e-9));
  EXPECT_FALSE(isNearly(robot.T_world_robot(), {1, 0, 0}, 1e-6, 1e-6));
}

TEST(Robot, WheelsGainSpeedAsFastAsTheyCanAndNoFaster)
{
  RobotOptions options = exactRobot();
  options.maxAcceleration_mps2 = 1;
  EXPECT_NEAR(driven(options, {0.5, -0.5}, 10).speeds().left_mps, 0.2, 1e-9);
  EXPECT_NEAR(driven(options, {0.5, -0.5}, 10).speeds().right_mps, -0.2, 1e-9);
  EXPECT_NEAR(driven(options, {0.5, 0.5}, 100).speeds().left_mps, 0.5, 1e-9);
}

TEST(Robot, NoWheelRunsFasterThanItCan)
{
  EXPECT_NEAR(driven(exactRobot(), {5, -5}, 1).speeds().left_mps, 1.2, 1e-9);
  EXPECT_NEAR(driven(exactRobot(), {5, -5}, 1).speeds().right_mps, -1.2, 1e-9);
}

TEST(Robot, ACollisionTakesTheLastStepBack)
{
  Robot robot(exactRobot(), {});
  std::mt19937_64 random(1);
  robot.advance({0.5, 0.5}, random);
  robot.advance({0.5, 0.5}, random);
  robot.stop();
  EXPECT_TRUE(isNearly(robot.T_world_robot(), {0.01, 0, 0}, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(robot.T_start_odometry(), {0.01, 0, 0}, 1e-12, 1e-12));
  EXPECT_EQ(robot.speeds().left_mps, 0);
}
}  // namespace psmks
