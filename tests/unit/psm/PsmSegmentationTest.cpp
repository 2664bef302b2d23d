/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/unit/psm/PsmScenes.h>

namespace psmks
{
namespace
{
using test::drawnScan;
using test::kNothing_m;
using test::prepared;

using Segments = std::vector<int>;

Segments segmentsOf(const std::vector<double>& range_m, double fieldOfView_rad = kPi)
{
  return prepared(drawnScan(range_m, fieldOfView_rad)).segment;
}

// range
//  5 |       o o o
//  2 | o o o
//    +--------------> ray
TEST(PsmSegmentation, AJumpEndsASurface)
{
  EXPECT_EQ(segmentsOf({2, 2, 2, 5, 5, 5}), (Segments{1, 1, 1, 2, 2, 2}));
}

TEST(PsmSegmentation, TheBreakIsAnOption)
{
  PsmOptions options = test::unfiltered();
  options.segmentBreak_m = 4;
  EXPECT_EQ(prepared(drawnScan({2, 2, 2, 5, 5, 5}), options).segment, Segments(6, 1));
}

// A reading on the edge of the near wall floats between both walls.
//
//  5 |         o o
//    |       x
//  2 | o o o
TEST(PsmSegmentation, APointBetweenTwoSurfacesIsLone)
{
  EXPECT_EQ(segmentsOf({2, 2, 2, 3.5, 5, 5}), (Segments{1, 1, 1, 0, 2, 2}));
}

// A wall seen at an ever smaller angle: the jumps grow beyond the break, but steadily.
TEST(PsmSegmentation, ASurfaceGoesOnWhereItsRangesGrowSteadily)
{
  EXPECT_EQ(segmentsOf({5, 5.15, 5.36, 5.66, 6.06}), Segments(5, 1));
  EXPECT_EQ(segmentsOf({5, 5.15, 5.36, 6.06}), (Segments{1, 1, 1, 0})) << "half a metre off";
}

TEST(PsmSegmentation, ThreeLonePointsInARowAreASurface)
{
  EXPECT_EQ(segmentsOf({5, 5.3, 5.6}), (Segments{1, 1, 1}));
  EXPECT_EQ(segmentsOf({5, 5.3}), (Segments{0, 0}));
  EXPECT_EQ(segmentsOf({5, 5.3, 6.2}), (Segments{0, 0, 0}));
}

TEST(PsmSegmentation, ARayWithoutReadingEndsASurface)
{
  EXPECT_EQ(segmentsOf({2, 2, kNothing_m, 2, 2}), (Segments{1, 1, 0, 2, 2}));
}

// Seen from above, the near wall lies across the seam of the scan:
//
//      5 5
//    5     5
//    2     2      rays 0 and 7 are neighbours
//      2|2
TEST(PsmSegmentation, AClosedScanHasNoSeam)
{
  EXPECT_EQ(segmentsOf({2, 2, 5, 5, 5, 5, 2, 2}, 2 * kPi), (Segments{2, 2, 1, 1, 1, 1, 2, 2}));
  EXPECT_EQ(segmentsOf({2, 2, 2, 2, 2, 2, 2, 2}, 2 * kPi), Segments(8, 1));
}

TEST(PsmSegmentation, TheEndsOfASpiralAreNotNeighbours)
{
  const PsmScan spiral = prepared(drawnScan({2, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7}, 2 * kPi));
  EXPECT_FALSE(spiral.sameSurface(7, 0));
  EXPECT_TRUE(spiral.sameSurface(0, 6));
}
}  // namespace
}  // namespace psmks
