/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/OccupancyGrid.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
using Cell = OccupancyGrid::Cell;

//   +----------------+     a room of 6 x 4 m around the origin, its walls in the middle of cells;
//   |                |     the robot stands at 1 and 2
//   |    1      2    |
//   |                |
//   +----------------+
constexpr double kLength_m = 6.04, kWidth_m = 4.04;

PosedScan scanFrom(const Pose2& T_world_robot, const std::vector<Wall>& walls)
{
  PosedScan posed;
  posed.T_world_robot.pose = T_world_robot;
  posed.T_robot_sensor = {0.2, 0.1, degToRad(15)};
  posed.scan =
      castScan(walls, T_world_robot * posed.T_robot_sensor, BeamGrid::centered(2 * kPi, 720));
  posed.isReference = true;
  return posed;
}

const std::vector<Pose2> kPlaces{{-1.5, 0, 0}, {1.5, 0, degToRad(70)}};

std::vector<PosedScan> scansOf(const std::vector<Wall>& walls)
{
  std::vector<PosedScan> scans;
  for (const Pose2& place : kPlaces) scans.push_back(scanFrom(place, walls));
  return scans;
}

OccupancyGrid gridOf(const std::vector<PosedScan>& scans)
{
  return makeOccupancyGrid(scans, PreprocessingOptions());
}

Cell cellAt(const OccupancyGrid& grid, const Eigen::Vector2d& place_m)
{
  return grid.at(grid.frame().column(place_m.x()), grid.frame().row(place_m.y()));
}
}  // namespace

TEST(OccupancyGrid, WallsAreOccupiedTheRoomIsFreeAndWhatIsBehindTheWallsUnknown)
{
  const OccupancyGrid grid = gridOf(scansOf(box({0, 0}, kLength_m, kWidth_m)));
  const UniformGrid& frame = grid.frame();
  EXPECT_DOUBLE_EQ(frame.cell_m(), 0.05);
  const double nearWall_m = frame.cell_m();
  for (int row = 0; row < frame.rows(); ++row)
    for (int column = 0; column < frame.columns(); ++column)
    {
      const Eigen::Vector2d centre_m = frame.centre_m(column, row);
      const Eigen::Vector2d outside_m =
          centre_m.cwiseAbs() - Eigen::Vector2d(kLength_m / 2, kWidth_m / 2);
      if (std::abs(outside_m.maxCoeff()) <= nearWall_m) continue;
      const Cell expected = outside_m.maxCoeff() > 0 ? Cell::Unknown : Cell::Free;
      EXPECT_EQ(grid.at(column, row), expected) << centre_m.transpose();
    }
}

TEST(OccupancyGrid, EveryRayEndsInAnOccupiedCell)
{
  const auto scans = scansOf(box({0, 0}, kLength_m, kWidth_m));
  const OccupancyGrid grid = gridOf(scans);
  for (const PosedScan& posed : scans)
    for (int ray = 0; ray < posed.scan.grid.count(); ++ray)
    {
      const Eigen::Vector2d end_m =
          posed.T_world_sensor() *
          (posed.scan.range_m[static_cast<std::size_t>(ray)] * posed.scan.grid.direction(ray));
      EXPECT_EQ(cellAt(grid, end_m), Cell::Occupied) << end_m.transpose();
    }
}

TEST(OccupancyGrid, WhatLaterScansSeeThroughIsFree)
{
  std::vector<Wall> withBox = box({0, 0}, kLength_m, kWidth_m);
  for (const Wall& side : box({0, 0}, 0.4, 0.4)) withBox.push_back(side);
  auto scans = scansOf(withBox);
  EXPECT_EQ(cellAt(gridOf(scans), {-0.2, 0.02}), Cell::Occupied);
  for (int more = 0; more < 6; ++more)
    for (const auto& later : scansOf(box({0, 0}, kLength_m, kWidth_m))) scans.push_back(later);
  EXPECT_EQ(cellAt(gridOf(scans), {-0.2, 0.02}), Cell::Free);
}

TEST(OccupancyGrid, OnlyReferencesAndValidRaysCount)
{
  auto scans = scansOf(box({0, 0}, kLength_m, kWidth_m));
  scans[1].isReference = false;
  scans[0].scan.maxRange_m = 2;
  const OccupancyGrid grid = gridOf(scans);
  EXPECT_LT(grid.frame().high_m().x(), kLength_m / 2);
  EXPECT_EQ(cellAt(grid, {-1.5, 0}), Cell::Free);
}

TEST(OccupancyGrid, NoScansAreOneUnknownCell)
{
  const OccupancyGrid grid = gridOf({});
  EXPECT_EQ(grid.frame().cells(), 1);
  EXPECT_EQ(grid.at(0, 0), Cell::Unknown);
}

TEST(OccupancyGrid, AWideWorldHasCoarserCellsAndNotMoreOfThem)
{
  auto scans = scansOf(box({0, 0}, kLength_m, kWidth_m));
  scans[1].T_world_robot.pose = {4e3, 4e3, 0};
  const OccupancyGrid grid = gridOf(scans);
  EXPECT_GT(grid.frame().cell_m(), 0.5);
  EXPECT_LE(grid.frame().cells(), 1 << 25);
}
}  // namespace psmks
