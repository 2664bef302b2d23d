/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/MovableObjects.h>
#include <psmks/segmentation/Preprocessing.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
const BeamGrid kHalfCircle = BeamGrid::centered(kPi, 181);

std::vector<std::uint8_t> movableRays(const Scan& raw)
{
  SegmentedScan scan;
  cleanScan(raw, {}, scan);
  std::vector<std::uint8_t> movable;
  findMovableObjects(scan, movable);
  return movable;
}

/** The rays that see a box (walls 1 to 4) before a wall (0). */
std::vector<std::uint8_t> raysOnBox(const std::vector<Wall>& walls, const BeamGrid& grid)
{
  std::vector<std::uint8_t> rays;
  for (const int wall : wallsSeen(walls, {}, grid, 30)) rays.push_back(wall >= 1);
  return rays;
}

/** A wall at x = 3 m with a box whose front is at `front_m`. */
std::vector<Wall> wallWithBox(double front_m, double depth_m, double width_m, double y_m = 0)
{
  std::vector<Wall> walls = {{{3, -20}, {3, 20}}};
  for (const Wall& side : box({front_m + depth_m / 2, y_m}, depth_m, width_m))
    walls.push_back(side);
  return walls;
}
}  // namespace

//              |
//     o   []   | wall
//              |
TEST(MovableObjects, APersonInFrontOfAWallIsMovable)
{
  const std::vector<Wall> walls = wallWithBox(1.5, 0.3, 0.4, 0.2);
  EXPECT_EQ(movableRays(castScan(walls, {}, kHalfCircle)), raysOnBox(walls, kHalfCircle));
}

//              |
//     o       []    a pillar that sticks out of the wall by 20 cm
//              |
TEST(MovableObjects, APillarAtTheWallIsNot)
{
  const std::vector<Wall> walls = wallWithBox(2.8, 0.2, 0.4);
  EXPECT_EQ(movableRays(castScan(walls, {}, kHalfCircle)), std::vector<std::uint8_t>(181, 0));
}

TEST(MovableObjects, WhatIsWiderThanAPersonIsNot)
{
  const std::vector<Wall> walls = wallWithBox(1.5, 0.3, 1.0);
  EXPECT_EQ(movableRays(castScan(walls, {}, kHalfCircle)), std::vector<std::uint8_t>(181, 0));
}

TEST(MovableObjects, NoReturnBesideAnObjectCountsAsFar)
{
  const std::vector<Wall> walls = box({1.5, 0}, 0.3, 0.4);
  const Scan scan = castScan(walls, {}, kHalfCircle);
  std::vector<std::uint8_t> returns;
  for (const double range_m : scan.range_m) returns.push_back(range_m < scan.maxRange_m);
  EXPECT_EQ(movableRays(scan), returns);
}

// The object is cut by the end of the field of view: what stands beside it is not seen.
TEST(MovableObjects, AnObjectAtTheEndOfTheViewIsNot)
{
  const std::vector<Wall> walls = wallWithBox(1.5, 0.3, 0.4);
  const BeamGrid fromTheMiddleOn(0, degToRad(1), 80);
  EXPECT_EQ(movableRays(castScan(walls, {}, fromTheMiddleOn)), std::vector<std::uint8_t>(80, 0));
}

TEST(MovableObjects, AnObjectAcrossTheSeamOfAClosedScanIsMovable)
{
  std::vector<Wall> walls = squareRoom();
  for (const Wall& side : box({-1.5, 0}, 0.3, 0.4)) walls.push_back(side);
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  std::vector<std::uint8_t> onBox;
  for (const int wall : wallsSeen(walls, {}, grid, 30)) onBox.push_back(wall >= 4);
  ASSERT_TRUE(onBox.front() && onBox.back());
  EXPECT_EQ(movableRays(castScan(walls, {}, grid)), onBox);
}

TEST(MovableObjects, AClosedRoomHasNone)
{
  EXPECT_EQ(movableRays(castScan(squareRoom(), {}, BeamGrid::centered(2 * kPi, 360))),
            std::vector<std::uint8_t>(360, 0));
}
}  // namespace psmks
