/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/AreaCenterDriver.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/Simulation.h>
#include <psmks/sim/WorldIndex.h>

namespace psmks
{
namespace
{
World boxOf(double width_m, double height_m)
{
  World world;
  world.addBox({0, 0}, {width_m, height_m});
  return world;
}

Scan scanFrom(const World& world, const Pose2& T_world_robot)
{
  LaserOptions laser;
  laser.maxRange_m = 30;
  laser.rangeSigma_m = 0;
  std::mt19937_64 random(1);
  return castScan(world, T_world_robot, laser, random).scan;
}

WheelSpeeds firstSpeeds(const World& world, const Pose2& T_world_robot)
{
  AreaCenterDriver driver({}, {}, 1);
  const Scan scan = scanFrom(world, T_world_robot);
  return driver.drive({scan, {}, {}, T_world_robot, {}, false, 0});
}

Recording roam(const World& world, const Pose2& T_world_start, double duration_s, unsigned seed = 1)
{
  SimulationOptions options;
  options.duration_s = duration_s;
  options.seed = seed;
  AreaCenterDriver driver({}, options.robot, seed);
  return simulate(WorldIndex(world), T_world_start, driver, options);
}
}  // namespace

TEST(AreaCenterDriver, DrivesStraightAtFullSpeedInTheOpen)
{
  // There is nothing within the reach of 5 m, so the speed is the gain 0.48 times 1.2 m/s.
  const WheelSpeeds speeds = firstSpeeds(boxOf(40, 40), {0, 0, 0});
  EXPECT_NEAR(speeds.left_mps, 0.576, 0.01);
  EXPECT_EQ(speeds.left_mps, speeds.right_mps);
}

TEST(AreaCenterDriver, TurnsToTheOpenSide)
{
  //   +-----------------------+
  //   |  o ->  (right wall 1 m off, the left one 9 m)
  //   +-----------------------+
  const WheelSpeeds toLeft = firstSpeeds(boxOf(20, 10), {-5, -4, 0});
  EXPECT_GT(toLeft.right_mps, toLeft.left_mps);
  const WheelSpeeds toRight = firstSpeeds(boxOf(20, 10), {-5, 4, 0});
  EXPECT_GT(toRight.left_mps, toRight.right_mps);
}

TEST(AreaCenterDriver, SlowsDownBeforeAWall)
{
  const World room = boxOf(20, 10);
  const WheelSpeeds open = firstSpeeds(room, {0, 0, 0});
  const WheelSpeeds near = firstSpeeds(room, {8, 0, 0});
  EXPECT_LT(std::max(near.left_mps, near.right_mps), 0.8 * open.left_mps);
}

TEST(AreaCenterDriver, HeadsForTheMiddleOfAnEmptyBox)
{
  // The robot starts in a corner along the wall, and has to be away from the wall after 8 s.
  const Recording recording = roam(boxOf(10, 10), {-4, -4, 0}, 8);
  const Eigen::Vector2d end_m = recording.scans.back().T_world_robot.translation();
  EXPECT_LT(end_m.norm(), 4);
  EXPECT_EQ(recording.collisions(), 0);
}

TEST(AreaCenterDriver, PassesABoxOnEitherSide)
{
  //   +---------------------------+
  //   |            +--+           |
  //   | o ->       |  |           |
  //   |            +--+           |
  //   +---------------------------+
  World world = boxOf(16, 8);
  world.addBox({0, 0}, {1, 1});
  bool left = false, right = false;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    const Recording recording = roam(world, {-5, 0, 0}, 25, seed);
    EXPECT_EQ(recording.collisions(), 0);
    for (const RecordedScan& scan : recording.scans)
    {
      if (std::abs(scan.T_world_robot.x_m) > 0.1) continue;
      (scan.T_world_robot.y_m > 0 ? left : right) = true;
    }
  }
  EXPECT_TRUE(left);
  EXPECT_TRUE(right);
}

TEST(AreaCenterDriver, TurnsRoundInADeadEnd)
{
  //   +-------------
  //   |       <- o     a blind alley of 1.5 m
  //   +-------------
  const Recording recording = roam(boxOf(12, 1.5), {0, 0, kPi}, 120);
  EXPECT_EQ(recording.collisions(), 0);
  EXPECT_LT(recording.longestStandstill_s(), 30);
  double eastmost_m = -6;
  for (const RecordedScan& scan : recording.scans)
    eastmost_m = std::max(eastmost_m, scan.T_world_robot.x_m);
  EXPECT_GT(eastmost_m, 4);
}

TEST(AreaCenterDriver, BacksOffWhereItBumped)
{
  AreaCenterDriver driver({}, {}, 1);
  const Scan scan = scanFrom(boxOf(20, 20), {});
  const WheelSpeeds speeds = driver.drive({scan, {}, {}, {}, {}, true, 5});
  EXPECT_LT(speeds.left_mps, 0);
  EXPECT_EQ(speeds.left_mps, speeds.right_mps);
}

TEST(AreaCenterDriver, RoamsForAMinuteWithoutTouchingAWall)
{
  const Recording recording = roam(World::smallRoom(), {-6, -4.5, 0.5}, 60);
  EXPECT_EQ(recording.collisions(), 0);
  EXPECT_GT(recording.distance_m(), 10);
  EXPECT_LT(recording.longestStandstill_s(), 15);
}

TEST(AreaCenterDriver, TheLaserBeyondItsReachChangesNothing)
{
  SimulationOptions options;
  options.duration_s = 30;
  const auto end = [&](double maxRange_m)
  {
    options.laser.maxRange_m = maxRange_m;
    AreaCenterDriver driver({}, options.robot, 1);
    return simulate(WorldIndex(boxOf(20, 20)), {}, driver, options).scans.back().T_world_robot;
  };
  EXPECT_EQ(end(8).x_m, end(30).x_m);
  EXPECT_EQ(end(8).phi_rad, end(30).phi_rad);
}
}  // namespace psmks
