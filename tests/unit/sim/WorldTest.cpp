/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

#include <cmath>

namespace psmks
{
namespace
{
//   +-----------+ 4        walls 0 to 3: the room, from the lower one counter-clockwise
//   |     +-+   |          walls 4 to 7: the box, in the same order
//   |     | |   |
//   | o   +-+   |          o = (1, 2)
//   |           |
//   +-----------+ 0
//   0     3 4   6
World roomWithBox()
{
  World world;
  world.addBox({3, 2}, {6, 4});
  world.addBox({3.5, 2.5}, {1, 1});
  return world;
}

const Eigen::Vector2d kOrigin_m(1, 2);
}  // namespace

TEST(World, ARayMeetsTheNearestWall)
{
  const World world = roomWithBox();
  const Hit box = world.cast({1, 2.5}, {1, 0}, 30, 0);
  EXPECT_DOUBLE_EQ(box.range_m, 2);
  EXPECT_EQ(box.object, 7);

  const Hit below = world.cast({1, 1.5}, {1, 0}, 30, 0);
  EXPECT_DOUBLE_EQ(below.range_m, 5);
  EXPECT_EQ(below.object, 1);
}

TEST(World, ARayAtAnAngleMeetsItsWallExactly)
{
  const Hit hit = roomWithBox().cast(kOrigin_m, Eigen::Vector2d(-1, -1).normalized(), 30, 0);
  EXPECT_EQ(hit.object, 3);
  EXPECT_NEAR(hit.range_m, std::sqrt(2), 1e-12);
}

TEST(World, AWallBeyondTheMaximumRangeIsNothing)
{
  EXPECT_EQ(roomWithBox().cast({1, 1.5}, {1, 0}, 4.99, 0).object, Hit::kNothing);
}

TEST(World, ALineIsSeenFromTheSensor)
{
  // The right wall is 5 m from the sensor, which looks up, so that the wall is to its right.
  const Line line = roomWithBox().lineFrom(1, {1, 2, kPi / 2});
  EXPECT_NEAR(line.r0_m, 5, 1e-12);
  EXPECT_NEAR(line.phi0_rad, -kPi / 2, 1e-12);
}

TEST(World, FreeIsInsideTheRoomAndOutsideTheBox)
{
  const World world = roomWithBox();
  EXPECT_TRUE(world.isFree(kOrigin_m));
  EXPECT_FALSE(world.isFree({3.5, 2.6}));
  EXPECT_FALSE(world.isFree({7, 2.6}));
  EXPECT_FALSE(world.isFree({-1, 2.6}));
}

TEST(World, ClearanceIsTheDistanceToTheNearestWall)
{
  EXPECT_DOUBLE_EQ(roomWithBox().clearance_m(kOrigin_m, 100, 0), 1);
  EXPECT_NEAR(roomWithBox().clearance_m({2.7, 1.6}, 100, 0), 0.5, 1e-12);
}

//   |
//   |     o  . -> x      a wall at x = 0, an isolated point, an arc of circle 0 and a person
TEST(World, PointsAreDiscsOfOneCentimetre)
{
  World world({{{0, -1}, {0, 1}}});
  world.addPoint({2, 0});
  const Hit hit = world.cast({5, 0}, {-1, 0}, 30, 0);
  EXPECT_DOUBLE_EQ(hit.range_m, 3 - World::kPointRadius_m);
  EXPECT_EQ(hit.object, World::kIsolatedPoint);
  EXPECT_EQ(world.cast({5, 0.011}, {-1, 0}, 30, 0).object, 0);
  EXPECT_DOUBLE_EQ(world.clearance_m({2, 0.5}, 100, 0), 0.5 - World::kPointRadius_m);
}

TEST(World, ARayMeetsWhatIsBeforeItOnly)
{
  World world;
  world.addPoint({2, 0});
  EXPECT_EQ(world.cast({1, 0}, {-1, 0}, 30, 0).object, Hit::kNothing);
}

TEST(World, PointsOfACircleAreOneObject)
{
  World world({{{0, -1}, {0, 1}}});
  world.addArc({{2, 0}, 0.5}, 0, 2 * kPi, 400);
  EXPECT_EQ(world.points().size(), 400U);
  EXPECT_EQ(world.cast({5, 0}, {-1, 0}, 30, 0).object, 1);
  EXPECT_EQ(world.cast({5, 0.3}, {-1, 0}, 30, 0).object, 1);
  EXPECT_NEAR(world.cast({5, 0}, {-1, 0}, 30, 0).range_m, 2.5 - World::kPointRadius_m, 1e-3);
}

TEST(World, AnArcIsOpenAndACircleIsClosed)
{
  World half, whole;
  half.addArc({{0, 0}, 1}, 0, kPi, 3);
  EXPECT_NEAR((half.points()[1].centre_m - Eigen::Vector2d(0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((half.points()[2].centre_m - Eigen::Vector2d(-1, 0)).norm(), 0, 1e-12);
  whole.addArc({{0, 0}, 1}, 0, 2 * kPi, 4);
  EXPECT_NEAR((whole.points()[3].centre_m - Eigen::Vector2d(0, -1)).norm(), 0, 1e-12);
}

TEST(World, APersonIsMetWhereItIsAtThatTime)
{
  World world({{{0, -1}, {0, 1}}});
  world.addMovingObject({0.25, 1, {{2, -3}, {2, 3}}});
  EXPECT_EQ(world.cast({5, 0}, {-1, 0}, 30, 0).object, 0);
  EXPECT_EQ(world.cast({5, 0}, {-1, 0}, 30, 3).object, 1);
  EXPECT_DOUBLE_EQ(world.cast({5, 0}, {-1, 0}, 30, 3).range_m, 2.75);
  EXPECT_DOUBLE_EQ(world.clearance_m({2, 0}, 100, 1), 1.75);
}

TEST(World, RandomPosesKeepTheirClearance)
{
  const World world = roomWithBox();
  std::mt19937_64 random(7);
  for (int i = 0; i < 100; ++i)
  {
    const Pose2 pose = world.randomFreePose(0.4, random);
    EXPECT_TRUE(world.isFree(pose.translation()));
    EXPECT_GE(world.clearance_m(pose.translation(), 100, 0), 0.4);
  }
}

TEST(World, TheRoomHas32WallsAndTheClutter68)
{
  EXPECT_EQ(World::smallRoom().walls().size(), 32U);
  EXPECT_EQ(World::smallClutter(1).walls().size(), 68U);
}

TEST(World, ASeedAlwaysGivesTheSameClutter)
{
  EXPECT_EQ(World::smallClutter(3).walls().back().a, World::smallClutter(3).walls().back().a);
  EXPECT_NE(World::smallClutter(3).walls().back().a, World::smallClutter(4).walls().back().a);
}

TEST(RayCasting, EveryRayHasItsRangeAndItsWall)
{
  std::mt19937_64 random(1);
  const LaserOptions threeRays{BeamGrid(-kPi / 2, kPi / 2, 3), 4.5, 0};
  const SimulatedScan simulated = castScan(roomWithBox(), {1, 1.5, 0}, threeRays, random);
  EXPECT_EQ(simulated.objectOfRay, (std::vector<int>{0, Hit::kNothing, 2}));
  EXPECT_NEAR(simulated.scan.range_m[0], 1.5, 1e-12);
  EXPECT_EQ(simulated.scan.range_m[1], 0);
  EXPECT_NEAR(simulated.scan.range_m[2], 2.5, 1e-12);
}

TEST(RayCasting, NoiseHasTheScannersSigma)
{
  std::mt19937_64 random(1);
  LaserOptions scanner;
  scanner.grid = BeamGrid::centered(0.05, 4001);
  const SimulatedScan simulated = castScan(roomWithBox(), {1, 2.5, 0}, scanner, random);
  double squares_m2 = 0;
  for (const double range_m : simulated.scan.range_m) squares_m2 += (range_m - 2) * (range_m - 2);
  EXPECT_NEAR(std::sqrt(squares_m2 / 4001), 0.01, 0.0005);
}
}  // namespace psmks
