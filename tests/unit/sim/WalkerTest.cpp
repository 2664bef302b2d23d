/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Walker.h>
#include <psmks/sim/World.h>

namespace psmks
{
namespace
{
// +-----+-----+ 3      two cells of 3 x 3 m, a door of 0.8 m in the wall between them
// |     |     |
// |  o        |
// |     |     |
// +-----+-----+ 0
// 0     3     6
World twoCells()
{
  World world;
  world.addBox({3, 1.5}, {6, 3});
  world.addWall({{3, 0}, {3, 1.1}});
  world.addWall({{3, 1.9}, {3, 3}});
  return world;
}
const Eigen::Vector2d kStart_m(1.5, 1.5);
}  // namespace

TEST(Walker, KeepsHisElbowRoomOnAllHisWays)
{
  const World world = twoCells();
  const WalkerOptions options{0.3, 0.5, 3};
  std::mt19937_64 random(1);
  Walker walker(world, kStart_m, options, random);
  ASSERT_TRUE(walker.walkOn(50));
  const auto path_m = walker.lastPoints_m(51);
  EXPECT_EQ(path_m.front(), kStart_m);
  EXPECT_EQ(path_m.back(), walker.place_m());
  bool wasBeyondTheDoor = false;
  for (std::size_t i = 1; i < path_m.size(); ++i)
  {
    EXPECT_TRUE(isPathFree(world, path_m[i - 1], path_m[i], options.clearance_m));
    const double length_m = (path_m[i] - path_m[i - 1]).norm();
    EXPECT_GE(length_m, options.shortestWay_m - 1e-9);
    EXPECT_LE(length_m, options.longestWay_m + 1e-9);
    wasBeyondTheDoor = wasBeyondTheDoor || path_m[i].x() > 3;
  }
  EXPECT_TRUE(wasBeyondTheDoor);
}

TEST(Walker, StaysWhereTheDoorIsTooNarrow)
{
  const World world = twoCells();
  std::mt19937_64 random(1);
  Walker walker(world, kStart_m, {0.45, 0.5, 3}, random);
  ASSERT_TRUE(walker.walkOn(50));
  for (const Eigen::Vector2d& place_m : walker.lastPoints_m(51)) EXPECT_LT(place_m.x(), 3);
}

TEST(Walker, SaysThatHeFindsNoWay)
{
  const World world = twoCells();
  std::mt19937_64 random(1);
  EXPECT_FALSE(Walker(world, kStart_m, {0.35, 5, 8}, random).walkOn());
}
}  // namespace psmks
