/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/DepthEdges.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
namespace
{
/** A scan of half a circle with one ray a degree, given by its ranges; 0 is no return. */
SegmentedScan scanOf(std::vector<double> range_m, const BeamGrid& grid)
{
  SegmentedScan scan;
  scan.grid = grid;
  scan.range_m = std::move(range_m);
  for (const double r : scan.range_m) scan.valid.push_back(r > 0 ? 1 : 0);
  return scan;
}

SegmentedScan halfCircleOf(std::vector<double> range_m)
{
  const int rays = static_cast<int>(range_m.size());
  return scanOf(std::move(range_m), BeamGrid(-kPi / 2, degToRad(1), rays));
}

std::vector<DepthEdge> edgesOf(const SegmentedScan& scan)
{
  std::vector<DepthEdge> edges;
  findDepthEdges(scan, edges);
  return edges;
}

/** 41 rays on a round wall, with an object before it. */
std::vector<double> objectBeforeWall(int first, int last, double object_m, double wall_m)
{
  std::vector<double> range_m(41, wall_m);
  for (int ray = first; ray <= last; ++ray) range_m[static_cast<std::size_t>(ray)] = object_m;
  return range_m;
}

double bearing_rad(const DepthEdge& edge) { return std::atan2(edge.point_m.y(), edge.point_m.x()); }
}  // namespace

//   ..........     wall at 4 m
//      ooo         object at 2 m, rays 20 to 24: it ends between rays 19, 20 and 24, 25
TEST(DepthEdges, AnObjectEndsBetweenItsOutermostRaysAndThoseThatPassIt)
{
  const SegmentedScan scan = halfCircleOf(objectBeforeWall(20, 24, 2, 4));
  const std::vector<DepthEdge> edges = edgesOf(scan);
  ASSERT_EQ(edges.size(), 2U) << "the wall has no edge where the object hides it";
  EXPECT_EQ(edges[0].step, -1);
  EXPECT_NEAR(bearing_rad(edges[0]), scan.grid.bearing_rad(20) - degToRad(0.5), 1e-9);
  EXPECT_EQ(edges[1].step, 1);
  EXPECT_NEAR(bearing_rad(edges[1]), scan.grid.bearing_rad(24) + degToRad(0.5), 1e-9);
  for (const DepthEdge& edge : edges)
  {
    EXPECT_NEAR(edge.point_m.norm(), 2, 1e-9);
    EXPECT_LT((edge.sight - edge.point_m.normalized()).norm(), 1e-9);
    const double spacing_m = 2 * degToRad(1);
    EXPECT_GT(edge.acrossVariance_m2, spacing_m * spacing_m / 12);
    EXPECT_LT(edge.acrossVariance_m2, spacing_m * spacing_m / 12 + 0.01 * 0.01);
  }
}

TEST(DepthEdges, AnObjectEndsWhereNothingIsSeenPastIt)
{
  EXPECT_EQ(edgesOf(halfCircleOf(objectBeforeWall(20, 24, 2, 0))).size(), 2U);
}

TEST(DepthEdges, AnObjectDoesNotEndAtTheEndOfTheFieldOfView)
{
  EXPECT_TRUE(edgesOf(halfCircleOf(std::vector<double>(41, 2))).empty());
}

// With a noise of 10 cm a step of 30 cm may be none.
TEST(DepthEdges, NoiseMakesNoEnds)
{
  SegmentedScan scan = halfCircleOf(objectBeforeWall(20, 24, 2, 2.3));
  scan.rangeNoise = {0.05};
  EXPECT_EQ(edgesOf(scan).size(), 2U);
  scan.rangeNoise = {0.1};
  EXPECT_TRUE(edgesOf(scan).empty());
}

TEST(DepthEdges, ASingleRayIsNoObject)
{
  EXPECT_TRUE(edgesOf(halfCircleOf(objectBeforeWall(20, 20, 2, 4))).empty());
}

// A gap in a fence: one ray passes, the next one meets it again.
TEST(DepthEdges, ASingleRayThatPassesIsNoEnd)
{
  EXPECT_TRUE(edgesOf(halfCircleOf(objectBeforeWall(20, 20, 4, 2))).empty());
}

// Along a wall that the rays graze the ranges grow by more than 15 cm from ray to ray, and faster
// and faster: r = 0.5 m / sin(bearing).
TEST(DepthEdges, AWallThatIsGrazedHasNone)
{
  std::vector<double> range_m;
  for (int ray = 0; ray < 60; ++ray) range_m.push_back(0.5 / std::sin(degToRad(62 - ray)));
  EXPECT_TRUE(edgesOf(halfCircleOf(range_m)).empty());
}

// A wall beside the scanner, seen up to the limit of the range: it goes on beyond.
TEST(DepthEdges, AWallThatLeavesTheRangeHasNone)
{
  constexpr double kLimit_m = 4;
  std::vector<double> range_m;
  for (int ray = 0; ray < 200; ++ray)
  {
    const double r_m = 1 / std::sin(degToRad(90 - 0.4 * ray));
    range_m.push_back(r_m < kLimit_m ? r_m : 0);
  }
  SegmentedScan scan = scanOf(range_m, BeamGrid(-kPi / 2, degToRad(0.4), 200));
  EXPECT_EQ(edgesOf(scan).size(), 1U) << "without a limit it ends";
  scan.maxRange_m = kLimit_m;
  EXPECT_TRUE(edgesOf(scan).empty());
}

// Every fifth ray of a wall is lost: three rays in a row without a return are no end of it.
TEST(DepthEdges, LostRaysAreNoEnds)
{
  std::vector<double> range_m(120, 3);
  for (std::size_t ray = 0; ray < range_m.size(); ++ray)
    if (ray % 5 == 1) range_m[ray] = 0;
  for (const std::size_t ray : {40U, 41U, 42U}) range_m[ray] = 0;
  EXPECT_TRUE(edgesOf(halfCircleOf(range_m)).empty());
  for (std::size_t ray = 40; ray < 60; ++ray) range_m[ray] = 0;
  EXPECT_FALSE(edgesOf(halfCircleOf(range_m)).empty()) << "a doorway";
}

// All round, an object across the seam of the grid ends on both sides of it, and not at the seam.
TEST(DepthEdges, TheSeamOfAClosedScanIsNoEnd)
{
  std::vector<double> range_m(360, 5);
  for (const std::size_t ray : {357U, 358U, 359U, 0U, 1U}) range_m[ray] = 1;
  const std::vector<DepthEdge> edges = edgesOf(scanOf(range_m, BeamGrid(0, degToRad(1), 360)));
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_NEAR(bearing_rad(edges[0]), degToRad(1.5), 1e-9);
  EXPECT_NEAR(bearing_rad(edges[1]), degToRad(-3.5), 1e-9);
}

TEST(DepthEdges, AnEmptyScanHasNone)
{
  EXPECT_TRUE(edgesOf(SegmentedScan()).empty());
  EXPECT_TRUE(edgesOf(halfCircleOf(std::vector<double>(41, 0))).empty());
}
}  // namespace psmks
