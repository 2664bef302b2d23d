/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/geometry/Angle.h>

#include <limits>

namespace psmks
{
namespace
{
/** Rays to the right (-90 deg), ahead and to the left. */
Scan threeRays(double right_m, double ahead_m, double left_m)
{
  Scan scan;
  scan.grid = BeamGrid(-kPi / 2, kPi / 2, 3);
  scan.range_m = {right_m, ahead_m, left_m};
  return scan;
}

std::size_t cellsOf(const Scan& scan)
{
  OccupiedCells cells;
  cells.add(scan, {});
  return cells.count();
}

TEST(OccupiedCells, EveryReturnWithinTheRangesFallsIntoACell)
{
  EXPECT_EQ(cellsOf(threeRays(1, 2, 3)), 3u);
  EXPECT_EQ(cellsOf(threeRays(0.09, 2, 15.1)), 1u);
  EXPECT_EQ(cellsOf(threeRays(std::numeric_limits<double>::quiet_NaN(), 0, -1)), 0u);
}

TEST(OccupiedCells, FlaggedRaysAndRaysBeyondTheScannersRangeAreNoReturns)
{
  Scan scan = threeRays(1, 2, 8);
  scan.maxRange_m = 8;
  scan.valid = {0, 1, 1};
  EXPECT_EQ(cellsOf(scan), 1u);
}

TEST(OccupiedCells, ACellIsCountedOnceAndCellsMeetAtMultiplesOfFiveCentimetres)
{
  OccupiedCells cells;
  for (const double ahead_m : {2.01, 2.02, 2.04}) cells.add(threeRays(0, ahead_m, 0), {});
  EXPECT_EQ(cells.count(), 1u);
  cells.add(threeRays(0, 2.06, 0), {});
  EXPECT_EQ(cells.count(), 2u);
}

TEST(OccupiedCells, TheSamePointSeenFromTwoPosesIsOneCell)
{
  OccupiedCells cells;
  cells.add(threeRays(0, 2.02, 0), {0, 0.02, 0});
  cells.add(threeRays(1.02, 0, 0), {2.02, 1.04, 0});
  EXPECT_EQ(cells.count(), 1u);
}
}  // namespace
}  // namespace psmks
