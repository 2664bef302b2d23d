/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/maps/CBeaconMap.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <psmks/mrpt/PolarView.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Says.h>
#include <tests/support/Scenes.h>
#include <tests/support/ThrownText.h>

#include <algorithm>
#include <limits>

namespace psmks::test
{
using mrpt::maps::CBeaconMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;

namespace
{
constexpr double kGap_m = 0.1;
const BeamGrid kAllRound = BeamGrid::centered(2 * kPi, 360);

/** Points every `spacing_m` on a wall. */
void addWall(CSimplePointsMap& map, const Wall& wall, double spacing_m)
{
  const int points = static_cast<int>((wall.b - wall.a).norm() / spacing_m);
  for (int i = 0; i <= points; ++i)
  {
    const Eigen::Vector2d p = wall.a + (wall.b - wall.a) * (double(i) / points);
    map.insertPoint(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
}

int validRays(const Scan& scan)
{
  return static_cast<int>(std::count(scan.valid.begin(), scan.valid.end(), 1));
}

/** The largest difference from the exact scan, over the rays of the view that are valid. */
double worstError_m(const Scan& view, const std::vector<Wall>& walls, const Pose2& T_world_sensor)
{
  const Scan exact = castScan(walls, T_world_sensor, view.grid);
  double worst_m = 0;
  for (std::size_t i = 0; i < view.valid.size(); ++i)
    if (view.valid[i]) worst_m = std::max(worst_m, std::abs(view.range_m[i] - exact.range_m[i]));
  return worst_m;
}
}  // namespace

TEST(PolarView, MeetsAWallBetweenItsPoints)
{
  const std::vector<Wall> room = squareRoom();
  CSimplePointsMap map;
  for (const Wall& wall : room) addWall(map, wall, 0.05);

  const Pose2 T_world_sensor{1.3, -0.7, degToRad(40)};
  const Scan view = polarView(map, T_world_sensor, kAllRound, kGap_m);
  EXPECT_EQ(validRays(view), 360);
  EXPECT_LT(worstError_m(view, room, T_world_sensor), 0.03);  // at the corners, which joins cut
}

//        ___________________   hidden, its points show through those of the wall in front
//        . . . . . . . . .     in front
//              o
TEST(PolarView, HidesWhatIsBehind)
{
  const Wall front{{-1, 1}, {1, 1}}, behind{{-3, 2}, {3, 2}};
  CSimplePointsMap map;
  addWall(map, front, 0.08);
  addWall(map, behind, 0.02);

  const Scan view = polarView(map, {}, kAllRound, kGap_m);
  EXPECT_LT(worstError_m(view, {front, behind}, {}), 1e-5);
}

TEST(PolarView, AveragesTheNoiseOfManyPoints)
{
  RandomNumbers random(3);
  SCOPED_TRACE(random.seedText());
  CSimplePointsMap map;
  for (int i = 0; i < 40000; ++i)
    map.insertPoint(static_cast<float>(random.uniform(-2, 2)),
                    static_cast<float>(2 + random.normal(0.02)));

  const Scan view = polarView(map, {0, 0, 0}, BeamGrid::centered(degToRad(60), 61), kGap_m);
  EXPECT_EQ(validRays(view), 0);  // the wall stands to the left

  const Scan left = polarView(map, {0, 0, kPi / 2}, BeamGrid::centered(degToRad(60), 61), kGap_m);
  double mean_m = 0;
  for (int i = 1; i < 60; ++i)  // the outermost joins may end before the outermost rays
    mean_m += left.range_m[static_cast<std::size_t>(i)] * left.grid.direction(i).x() / 59;
  EXPECT_NEAR(mean_m, 2, 0.004);  // the nearest points alone would give 1.93
}

TEST(PolarView, LeavesOutWhatIsNoSurface)
{
  CSimplePointsMap map;
  map.insertPoint(2, 0);
  map.insertPoint(0, 2);
  map.insertPoint(0, 0);
  map.insertPoint(std::numeric_limits<float>::quiet_NaN(), 1);
  EXPECT_EQ(validRays(polarView(map, {}, kAllRound, kGap_m)), 0);

  map.insertPoint(2, 0.05f);
  EXPECT_GT(validRays(polarView(map, {}, kAllRound, kGap_m)), 0);
  EXPECT_EQ(validRays(polarView(map, {}, kAllRound, 0.001)),
            2);  // 1.4 deg: ray spacing still joins
}

TEST(PolarView, JoinsAcrossTheSeam)
{
  const Wall behind{{-2, 1}, {-2, -1}};
  CSimplePointsMap map;
  addWall(map, behind, 0.05);
  const Scan view = polarView(map, {}, kAllRound, kGap_m);
  EXPECT_EQ(validRays(view), 53);  // -153.4 to 153.4 degrees, whole degrees
  EXPECT_LT(worstError_m(view, {behind}, {}), 1e-5);
}

namespace
{
/** A grid of 5 cm cells about the origin, free but for a wall of one cell at x = 9.5 m. */
COccupancyGridMap2D gridWithWall()
{
  COccupancyGridMap2D map(-10, 10, -10, 10, 0.05f);
  map.fill(0.95f);
  for (double y_m = -9.9; y_m < 9.9; y_m += 0.025)
    map.setCell(map.x2idx(9.5f), map.y2idx(y_m), 0.02f);
  return map;
}
}  // namespace

//  Ranges end in the middles of the cells, where the surface is on average, and not at their faces.
TEST(PolarView, MeetsTheMiddlesOfTheCellsOfAGrid)
{
  const COccupancyGridMap2D map = gridWithWall();
  const Pose2 T_map_sensor{-9.5, 0, 0};  // 19 m from the wall
  const Scan view = polarView(map, T_map_sensor, BeamGrid::centered(degToRad(40), 41), kGap_m);
  const double middle_m = map.idx2x(map.x2idx(9.5f));
  const std::vector<Wall> wall{{{middle_m, -20}, {middle_m, 20}}};
  EXPECT_GE(validRays(view), 39);  // the outermost joins may end before the outermost rays
  EXPECT_LT(worstError_m(view, wall, T_map_sensor), 1e-3);
  EXPECT_NEAR(view.rangeSigma_m, 0.0144, 0.0001);
}

TEST(PolarView, LooksAtThePointsOfAMultiMetricMapElseAtItsGrid)
{
  const auto points = CSimplePointsMap::Create();
  const auto grid = COccupancyGridMap2D::Create(gridWithWall());
  CMultiMetricMap multi;
  multi.maps = {CBeaconMap::Create(), points, grid};
  const BeamGrid ahead = BeamGrid::centered(degToRad(10), 11);
  EXPECT_NEAR(polarView(multi, {}, ahead, kGap_m).range_m[5], 9.5, 0.05);

  addWall(*points, {{2, -1}, {2, 1}}, 0.05);
  EXPECT_NEAR(polarView(multi, {}, ahead, kGap_m).range_m[5], 2, 1e-5);
}

TEST(PolarView, IsEmptyForAnEmptyMapOrAnUnknownPlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(validRays(polarView(CSimplePointsMap(), {}, kAllRound, kGap_m)), 0);
  EXPECT_EQ(validRays(polarView(COccupancyGridMap2D(), {}, kAllRound, kGap_m)), 0);
  EXPECT_EQ(validRays(polarView(gridWithWall(), {nan, 0, 0}, kAllRound, kGap_m)), 0);
  EXPECT_EQ(validRays(polarView(gridWithWall(), {1e300, 0, 0}, kAllRound, kGap_m)), 0);
}

TEST(PolarView, RefusesOtherClassesByName)
{
  const auto text =
      thrownText<std::invalid_argument>([] { polarView(CBeaconMap(), {}, kAllRound, kGap_m); });
  EXPECT_TRUE(says(text, {"CBeaconMap", "COccupancyGridMap2D"}));
  CMultiMetricMap multi;
  multi.maps = {CBeaconMap::Create()};
  EXPECT_TRUE(
      says(thrownText<std::invalid_argument>([&] { polarView(multi, {}, kAllRound, kGap_m); }),
           {"CMultiMetricMap"}));
}
}  // namespace psmks::test
