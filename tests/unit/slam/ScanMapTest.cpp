/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/ScanMap.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <cmath>

namespace psmks
{
namespace
{
//   +-----+    a square room of 6 m about (10, 5); the robot stands in its middle and the sensor
//   |  o  |    a little ahead of it
//   +-----+
PosedScan scanOfRoom()
{
  const Pose2 T_room_robot{0, 0, degToRad(30)};
  PosedScan posed;
  posed.T_robot_sensor = {0.2, 0, 0};
  posed.T_world_robot.pose = Pose2{10, 5, 0} * T_room_robot;
  posed.scan =
      castScan(squareRoom(), T_room_robot * posed.T_robot_sensor, BeamGrid::centered(2 * kPi, 360));
  return posed;
}

/** How far a point is from the walls of the room. */
double distanceFromWalls_m(const Eigen::Vector2d& point_m)
{
  const Eigen::Vector2d inRoom_m = point_m - Eigen::Vector2d(10, 5);
  return std::abs(inRoom_m.cwiseAbs().maxCoeff() - 3);
}
}  // namespace

TEST(ScanMap, PointsAndWallsStandInTheWorld)
{
  PosedScan reference = scanOfRoom();
  reference.isReference = true;
  const ScanMap map = makeScanMap({reference}, {});
  EXPECT_EQ(map.points_m.size(), 360U);
  for (const Eigen::Vector2d& point_m : map.points_m) EXPECT_LT(distanceFromWalls_m(point_m), 1e-9);
  ASSERT_EQ(map.walls.size(), 4U);
  for (const ScanMap::Wall& wall : map.walls)
  {
    EXPECT_LT(distanceFromWalls_m(wall.from_m), 1e-6);
    EXPECT_LT(distanceFromWalls_m(wall.to_m), 1e-6);
    EXPECT_GT(wall.points, 50);
  }
}

TEST(ScanMap, OnlyReferencesShowWalls)
{
  const ScanMap map = makeScanMap({scanOfRoom()}, {});
  EXPECT_TRUE(map.walls.empty());
  EXPECT_EQ(map.points_m.size(), 360U);
}

TEST(ScanMap, APathIsOnePoseAScanAndThatOfOdometryOnlyWhereItMoved)
{
  PosedScan moved = scanOfRoom();
  EXPECT_TRUE(makeScanMap({moved, moved}, {}).odometryPath.empty());
  moved.T_world_odometry = {1, 0, 0};
  const ScanMap map = makeScanMap({scanOfRoom(), moved}, {});
  ASSERT_EQ(map.path.size(), 2U);
  EXPECT_TRUE(isNearly(map.path[1], moved.T_world_robot.pose, 0, 0));
  ASSERT_EQ(map.odometryPath.size(), 2U);
  EXPECT_TRUE(isNearly(map.odometryPath[1], moved.T_world_odometry, 0, 0));
}

//   +-----+    a box of 1 m beside the robot in one of four scans; the others saw the walls behind
//   it | o # |
//   +-----+
TEST(ScanMap, LeavesOutWhatHasMoved)
{
  std::vector<Wall> withBox = squareRoom();
  for (const Wall& side : box({1.5, 0}, 1, 1)) withBox.push_back(side);
  std::vector<PosedScan> scans(4, scanOfRoom());
  for (PosedScan& scan : scans) scan.isReference = true;
  const ScanMap still = makeScanMap(scans, {});
  EXPECT_TRUE(still.moving_m.empty());
  const Pose2 T_room_sensor = Pose2{10, 5, 0}.inverse() * scans[0].T_world_sensor();
  scans[0].scan = castScan(withBox, T_room_sensor, scans[0].scan.grid);
  const ScanMap map = makeScanMap(scans, {});
  EXPECT_GT(map.moving_m.size(), 20U);
  EXPECT_EQ(map.points_m.size() + map.moving_m.size(), still.points_m.size());
  for (const ScanMap::Wall& wall : map.walls)
    EXPECT_LT(distanceFromWalls_m((wall.from_m + wall.to_m) / 2), 0.01);
}

TEST(ScanMap, OfNoScansIsEmpty)
{
  const ScanMap map = makeScanMap({}, {});
  EXPECT_TRUE(map.points_m.empty());
  EXPECT_TRUE(map.path.empty());
}
}  // namespace psmks
