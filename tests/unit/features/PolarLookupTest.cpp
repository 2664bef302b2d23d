/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/ScanFeatures.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
/** Everything that a surface is built from, for the walls of a room. */
ScanFeatures viewOf(const SegmentedScan& scan)
{
  ScanFeatures view;
  view.build(scan);
  return view;
}

SegmentedScan roomOn(const BeamGrid& grid)
{
  return segmentByWalls(castScan(squareRoom(), {}, grid), squareRoom(), {});
}

/** The cell by the grid's own arithmetic, -1 outside; `toBorder` in cells. */
int expectedCell(const BeamGrid& grid, double bearing_rad, double& toBorder)
{
  const double index = grid.index(bearing_rad);
  toBorder = std::abs(index - std::round(index));
  const int below = static_cast<int>(std::floor(index));
  if (grid.closed()) return below < 0 ? grid.count() - 1 : below;
  return below < 0 || below >= grid.count() - 1 ? -1 : below;
}

class PolarSurfaceOnGrid : public testing::TestWithParam<BeamGrid>
{
};

INSTANTIATE_TEST_SUITE_P(
    Grids, PolarSurfaceOnGrid,
    testing::Values(BeamGrid::centered(kPi / 3, 61), BeamGrid::centered(kPi, 181),
                    BeamGrid::centered(1.5 * kPi, 1081), BeamGrid::centered(2 * kPi, 360),
                    BeamGrid(0, degToRad(1), 360), BeamGrid(2.5, degToRad(1), 180),
                    BeamGrid(-3.5, degToRad(0.5), 720)),
    [](const auto& grid) { return "Grid" + std::to_string(grid.index); });
}  // namespace

// The fast look-up in single precision agrees with the one place of bearing arithmetic.
TEST_P(PolarSurfaceOnGrid, CellsAreThoseOfTheGrid)
{
  const BeamGrid& grid = GetParam();
  const SegmentedScan scan = roomOn(grid);
  const ScanFeatures view = viewOf(scan);
  EXPECT_EQ(view.surface.cells(), grid.closed() ? grid.count() : grid.count() - 1);

  constexpr double kRounding = 0.01;  // of a cell
  test::RandomNumbers random(41);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 20000; ++i)
  {
    // every second point within two rays of a seam: of the grid's ends or of atan2
    const double seam_rad = i % 4 == 1 ? grid.firstBearing_rad() : kPi;
    const double bearing_rad = i % 2 == 0 ? random.uniform(-kPi, kPi)
                                          : seam_rad + random.uniform(-2, 2) * grid.increment_rad();
    double toBorder = 0;
    const int expected = expectedCell(grid, bearing_rad, toBorder);
    if (toBorder < kRounding) continue;
    const double range_m = random.uniform(0.1, 20);
    EXPECT_EQ(view.surface.cellOf(static_cast<float>(range_m * std::cos(bearing_rad)),
                                  static_cast<float>(range_m * std::sin(bearing_rad))),
              expected)
        << "bearing " << radToDeg(bearing_rad) << " deg";
  }
}

//    ---------------+ 3     both sides of a cell on a wall are that wall's line; the cell of the
//          o        |       corner has one side of each
TEST(PolarLookup, CellsHoldTheLinesOnBothSides)
{
  const BeamGrid grid = BeamGrid::centered(kPi, 182);
  const SegmentedScan scan = roomOn(grid);
  const ScanFeatures view = viewOf(scan);
  const PolarLookup::Side* ahead = view.surface.sides(view.surface.cellOf(2, 0));
  for (const int side : {0, 1})
  {
    EXPECT_NEAR(ahead[side].nx, 1, 1e-6);
    EXPECT_NEAR(ahead[side].d, 3, 1e-6);
    EXPECT_NEAR(ahead[side].distance_m(2, 0.5f), -1, 1e-6);
  }
  const PolarLookup::Side* corner = view.surface.sides(view.surface.cellOf(1, 1));
  EXPECT_NEAR(corner[0].nx, 1, 1e-6);
  EXPECT_NEAR(corner[1].ny, 1, 1e-6);
  EXPECT_NE(corner[0].line, corner[1].line);
}

TEST(PolarLookup, ARayWithoutALineStandsForItsCircle)
{
  SegmentedScan scan = roomOn(BeamGrid::centered(kPi, 181));
  scan.segmentOfRay[90] = SegmentedScan::kNoSegment;
  scan.range_m[90] = 2;
  const ScanFeatures view = viewOf(scan);
  const PolarLookup::Side* sides = view.surface.sides(90);
  EXPECT_EQ(sides[0].line, -1);
  EXPECT_NEAR(sides[0].d, 2, 1e-6);
  EXPECT_NEAR(sides[0].nx, 1, 1e-6);
  EXPECT_NEAR(sides[1].d, 3, 1e-6) << "the wall goes on at the next ray";
}

TEST(PolarLookup, ACellBesideAnInvalidRayIsUnknown)
{
  SegmentedScan scan = roomOn(BeamGrid::centered(kPi, 181));
  scan.valid[90] = 0;
  const ScanFeatures view = viewOf(scan);
  EXPECT_TRUE(view.surface.known(88));
  EXPECT_FALSE(view.surface.known(89));
  EXPECT_FALSE(view.surface.known(90));
  EXPECT_TRUE(view.surface.known(91));
}
}  // namespace psmks
