/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/MovingReturns.h>
#include <tests/support/Scenes.h>

#include <algorithm>

namespace psmks
{
namespace
{
//   +-----------+   a square room of 6 m; keyframes k look about from four places. A person p, a
//   box | k       k |   of 0.4 m, stood before the wall on the right when one more scan s was
//   taken. |     s   p | | k       k |
//   +-----------+
const std::vector<Pose2> kPlaces{{-1, -1, 0}, {1.5, -1.5, 1}, {1.5, 1.5, 2}, {-1, 1, 3}};

std::vector<Wall> roomWithPerson()
{
  std::vector<Wall> walls = squareRoom();
  for (const Wall& side : box({1.5, 0}, 0.4, 0.4)) walls.push_back(side);
  return walls;
}

PosedScan scanAt(const std::vector<Wall>& walls, const Pose2& T_world_robot)
{
  PosedScan posed;
  posed.T_world_robot.pose = T_world_robot;
  posed.scan = castScan(walls, T_world_robot, BeamGrid::centered(2 * kPi, 360));
  posed.isReference = true;
  return posed;
}

std::vector<PosedScan> keyframes(const std::vector<Wall>& walls)
{
  std::vector<PosedScan> scans;
  for (const Pose2& place : kPlaces) scans.push_back(scanAt(walls, place));
  return scans;
}

long flagged(const std::vector<std::uint8_t>& moving)
{
  return std::count(moving.begin(), moving.end(), 1);
}
}  // namespace

TEST(MovingReturns, WhoOnlyOneScanMetHasMoved)
{
  std::vector<PosedScan> scans = keyframes(squareRoom());
  scans.push_back(scanAt(roomWithPerson(), {0, 0, 0}));
  const std::vector<std::uint8_t> moving = MovingReturns(scans).of(4);
  ASSERT_EQ(moving.size(), 360U);
  for (int ray = 0; ray < 360; ++ray)
  {
    const auto i = static_cast<std::size_t>(ray);
    const bool isOnPerson = scans[4].scan.range_m[i] < 2;
    EXPECT_EQ(moving[i] != 0, isOnPerson) << "ray " << ray;
  }
  EXPECT_GT(flagged(moving), 10);
}

TEST(MovingReturns, WhatStaysIsNotFlagged)
{
  std::vector<PosedScan> scans = keyframes(roomWithPerson());
  scans.push_back(scanAt(roomWithPerson(), {0, 0, 0}));
  const MovingReturns moving(scans);
  for (std::size_t s = 0; s < scans.size(); ++s) EXPECT_EQ(flagged(moving.of(s)), 0) << s;
}

TEST(MovingReturns, WhoLeftIsFlaggedInTheScansThatMetHim)
{
  std::vector<PosedScan> scans = keyframes(squareRoom());
  scans[0] = scanAt(roomWithPerson(), kPlaces[0]);
  const MovingReturns moving(scans);
  EXPECT_GT(flagged(moving.of(0)), 3);
  EXPECT_EQ(flagged(moving.of(1)), 0) << "the wall behind him is no moving thing";
}

TEST(MovingReturns, OneWitnessIsNotEnough)
{
  std::vector<PosedScan> scans{scanAt(squareRoom(), kPlaces[0]),
                               scanAt(roomWithPerson(), {0, 0, 0})};
  EXPECT_EQ(flagged(MovingReturns(scans).of(1)), 0);
}

TEST(MovingReturns, RaysThatAreFarApartSayNothing)
{
  std::vector<PosedScan> scans = keyframes(squareRoom());
  for (PosedScan& scan : scans)
    scan.scan = castScan(squareRoom(), scan.T_world_robot.pose, BeamGrid::centered(2 * kPi, 24));
  scans.push_back(scanAt(roomWithPerson(), {0, 0, 0}));
  EXPECT_EQ(flagged(MovingReturns(scans).of(4)), 0);
}

TEST(MovingReturns, AScanWithoutItsRangesHasNone)
{
  std::vector<PosedScan> scans = keyframes(squareRoom());
  scans[1].scan.range_m.clear();
  const MovingReturns moving(scans);
  EXPECT_EQ(flagged(moving.of(1)), 0);
  EXPECT_EQ(flagged(moving.of(0)), 0);
}
}  // namespace psmks
