/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/RayPoints.h>
#include <tests/support/Scenes.h>

#include <algorithm>
#include <numeric>

namespace psmks
{
namespace
{
/** The end points of a scan of some walls from the origin. */
RayPoints pointsOf(const std::vector<Wall>& walls, const BeamGrid& grid)
{
  RayPoints points;
  points.build(segmentByWalls(castScan(walls, {}, grid), walls, {}));
  return points;
}

double sumOfLooks(const RayPoints& points)
{
  return std::accumulate(points.looks.begin(), points.looks.end(), 0.0);
}

const BeamGrid kDegrees = BeamGrid::centered(kPi, 181);
}  // namespace

//         |
//  o   |  |     a person is 0.5 m wide: 1 m away 28 rays see it, 4 m away 7
//         |
TEST(RayPoints, ANearObjectOfManyRaysCountsAsMuchAsAFarOneOfTheSameSize)
{
  const auto facing = [](double x_m) { return std::vector<Wall>{{{x_m, -0.25}, {x_m, 0.25}}}; };
  const RayPoints near = pointsOf(facing(1), kDegrees), far = pointsOf(facing(4), kDegrees);
  EXPECT_GT(near.size(), 3 * far.size());
  // The edges of the far object lie anywhere between two rays, of 7 cm each.
  EXPECT_NEAR(sumOfLooks(near), 0.5 / RayPoints::kLook_m, 0.1);
  EXPECT_NEAR(sumOfLooks(far), 0.5 / RayPoints::kLook_m, 0.07 / RayPoints::kLook_m);
}

// A finer scanner sees the same surfaces.
TEST(RayPoints, MoreRaysOnASurfaceAreNotMoreLooks)
{
  const double coarse = sumOfLooks(pointsOf(squareRoom(), BeamGrid::centered(2 * kPi, 360)));
  const double fine = sumOfLooks(pointsOf(squareRoom(), BeamGrid::centered(2 * kPi, 1440)));
  EXPECT_NEAR(fine, coarse, 0.01 * coarse);
}

// Rays of 5 degrees are 0.25 m apart at 2.86 m. One ray is never more than one look.
TEST(RayPoints, APointIsTheLengthBetweenTwoRaysAndAtMostOneLook)
{
  const double step_rad = degToRad(5);
  const auto lookAt = [&](double x_m)
  {
    const std::vector<Wall> wall{{{x_m, -1}, {x_m, 1}}};
    const RayPoints points = pointsOf(wall, BeamGrid(0, step_rad, 2));
    return points.looks.at(0);
  };
  EXPECT_NEAR(lookAt(1), step_rad / RayPoints::kLook_m, 1e-6);
  EXPECT_NEAR(lookAt(2.8), 2.8 * step_rad / RayPoints::kLook_m, 1e-6);
  EXPECT_EQ(lookAt(3), 1);
  EXPECT_EQ(lookAt(9), 1);
}

// Where only every second ray returns, each stands for the surface to the next one that does: holes
// of up to three such distances leave a surface whole.
TEST(RayPoints, OfASparseScanAPointStandsForTheUsualDistanceBetweenReturns)
{
  const std::vector<Wall> wall{{{1, -2}, {1, 2}}};
  SegmentedScan scan = segmentByWalls(castScan(wall, {}, kDegrees), wall, {});
  RayPoints dense, sparse;
  dense.build(scan);
  scan.returnSpacing = 2;
  sparse.build(scan);
  ASSERT_EQ(sparse.size(), dense.size());
  for (std::size_t i = 0; i < dense.size(); ++i)
    EXPECT_NEAR(sparse.looks[i], std::min(1.0f, 2 * dense.looks[i]), 1e-6);
}

//        |     the ray between two that return has none
//    o - |
TEST(RayPoints, InvalidRaysAreLeftOutOfAllArrays)
{
  const std::vector<Wall> wall{{{2, -1}, {2, 1}}};
  SegmentedScan scan = segmentByWalls(castScan(wall, {}, kDegrees), wall, {});
  RayPoints all;
  std::vector<std::uint8_t> movable(181, 0);
  movable[91] = 1;
  all.build(scan, movable);
  scan.valid[90] = 0;
  RayPoints points;
  points.build(scan, movable);
  ASSERT_EQ(points.size(), all.size() - 1);
  EXPECT_EQ(points.looks.size(), points.size());
  EXPECT_EQ(points.movable.size(), points.size());
  EXPECT_EQ(std::count(points.movable.begin(), points.movable.end(), 1), 1);
  const auto ahead = std::find(points.movable.begin(), points.movable.end(), 1);
  const auto place = static_cast<std::size_t>(ahead - points.movable.begin());
  EXPECT_NEAR(points.y_m[place], 2 * std::tan(degToRad(1)), 1e-5) << "the flag of its own point";
}
}  // namespace psmks
