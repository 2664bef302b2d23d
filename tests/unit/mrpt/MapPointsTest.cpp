/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/maps/CBeaconMap.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <psmks/mrpt/MapPoints.h>
#include <tests/support/Says.h>
#include <tests/support/ThrownText.h>
#include <tests/unit/mrpt/Observation.h>

#include <cmath>
#include <limits>

namespace psmks::test
{
using mrpt::maps::CBeaconMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;

TEST(MapPoints, AreThoseOfAPointMapThatAreFiniteAndInTheRegion)
{
  CSimplePointsMap map;
  map.insertPoint(1, 2);
  map.insertPoint(-3, 0);
  map.insertPoint(std::numeric_limits<float>::quiet_NaN(), 0);
  const MapPoints all = pointsOf(map);
  ASSERT_EQ(all.points_m.size(), 2U);
  EXPECT_EQ(all.points_m[0], Eigen::Vector2d(1, 2));
  EXPECT_EQ(all.cell_m, 0);
  EXPECT_EQ(all.cellSigma_m(), 0);

  const MapPoints part = pointsOf(map, {{0, 1}, 1.5});
  ASSERT_EQ(part.points_m.size(), 1U);
  EXPECT_EQ(part.points_m[0], Eigen::Vector2d(1, 2));
}

//   |  #  free   |  # at x = 2.0 to 2.1 m: the point is its middle
TEST(MapPoints, AreTheMiddlesOfTheOccupiedCellsOfAGrid)
{
  COccupancyGridMap2D map(-5, 5, -5, 5, 0.1f);
  map.fill(0.8f);
  map.setCell(map.x2idx(2.05f), map.y2idx(1.05f), 0.1f);
  map.setCell(map.x2idx(-2.05f), map.y2idx(1.05f), 0.5f);  // unknown
  const MapPoints points = pointsOf(map);
  ASSERT_EQ(points.points_m.size(), 1U);
  EXPECT_NEAR(points.points_m[0].x(), 2.05, 1e-5);
  EXPECT_NEAR(points.points_m[0].y(), 1.05, 1e-5);
  EXPECT_NEAR(points.cellSigma_m(), 0.1 / std::sqrt(12.0), 1e-6);

  EXPECT_EQ(pointsOf(map, {{2, 1}, 0.2}).points_m.size(), 1U);
  EXPECT_TRUE(pointsOf(map, {{2, 2}, 0.2}).points_m.empty());
  EXPECT_TRUE(pointsOf(map, {{500, 0}, 1}).points_m.empty());
}

TEST(MapPoints, AreThereAfterOneHitWithTheCertaintyOfStockIniFiles)
{
  COccupancyGridMap2D map(-6, 6, -6, 6, 0.05f);
  map.insertionOptions.maxOccupancyUpdateCertainty = 0.54f;
  map.insertObservation(observe(squareRoom(), {0, 0, 0}));
  const MapPoints points = pointsOf(map);
  EXPECT_GT(points.points_m.size(), 150U);
  for (const Eigen::Vector2d& p : points.points_m)  // the walls stand at 3 m, in cells of 5 cm
    EXPECT_NEAR(p.cwiseAbs().maxCoeff(), 3, 0.06) << p.transpose();
}

TEST(MapPoints, AreThoseOfThePointMapInAMultiMetricMapElseOfTheGrid)
{
  const auto points = CSimplePointsMap::Create();
  const auto grid = COccupancyGridMap2D::Create(-5.f, 5.f, -5.f, 5.f, 0.1f);
  grid->setCell(3, 3, 0.1f);
  CMultiMetricMap multi;
  multi.maps = {CBeaconMap::Create(), points, grid};
  EXPECT_GT(pointsOf(multi).cell_m, 0);
  points->insertPoint(1, 0);
  EXPECT_EQ(pointsOf(multi).cell_m, 0);
  EXPECT_EQ(pointsOf(multi).points_m.size(), 1U);
}

TEST(MapPoints, AreNoneOfAnEmptyMapOrInARegionNowhere)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CSimplePointsMap map;
  EXPECT_TRUE(pointsOf(map).points_m.empty());
  EXPECT_TRUE(pointsOf(COccupancyGridMap2D()).points_m.empty());
  map.insertPoint(1, 0);
  EXPECT_TRUE(pointsOf(map, {{nan, 0}, 1}).points_m.empty());
}

TEST(MapPoints, OfOtherClassesAreRefusedByName)
{
  EXPECT_TRUE(says(thrownText<std::invalid_argument>([] { pointsOf(CBeaconMap()); }),
                   {"CBeaconMap", "COccupancyGridMap2D"}));
}
}  // namespace psmks::test
