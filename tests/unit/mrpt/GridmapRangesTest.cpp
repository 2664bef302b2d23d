/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/geometry/Angle.h>
#include <psmks/mrpt/GridmapRanges.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <fstream>

namespace psmks
{
namespace
{
/** Step of a grid map's ray caster, in cells, where it is an option of each map: MRPT 3. */
template <class GridMap>
auto raytraceStep_cells(const GridMap& map)
    -> decltype(double(map.insertionOptions.raytraceStepSizeInCellUnits))
{
  return map.insertionOptions.raytraceStepSizeInCellUnits;
}

/** The same where it is a static member of the class: MRPT 2. */
template <class GridMap>
auto raytraceStep_cells(const GridMap&)
    -> decltype(double(GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS))
{
  return GridMap::RAYTRACE_STEP_SIZE_IN_CELL_UNITS;
}

using mrpt::maps::COccupancyGridMap2D;

constexpr float kFree = 1, kSolid = 0, kUnknown = 0.5f;

/** 25 cm a cell (exact in binary); the origin is the corner between the cells 8 and 7 on each axis.
 *
 *     ################   15
 *     #..............#
 *     #.......##.....#   cells 8 and 9 in row 13: a block
 *     #..............#
 *     #....o.........#   o: the origin's cell is (8, 8)
 *     #..............#
 *     ################   0      outside: unknown                                            */
COccupancyGridMap2D room()
{
  COccupancyGridMap2D map(-2, 2, -2, 2, 0.25f);
  map.fill(kFree);
  for (int i = 0; i < 16; ++i)
    for (const int edge : {0, 15})
    {
      map.setCell(i, edge, kSolid);
      map.setCell(edge, i, kSolid);
    }
  map.setCell(8, 13, kSolid);
  map.setCell(9, 13, kSolid);
  return map;
}

Eigen::Vector2d toward(double bearing_deg)
{
  const double bearing_rad = degToRad(bearing_deg);
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

/** -1 where nothing is met. */
double range_m(const GridmapRanges& map, const Eigen::Vector2d& from_m, double bearing_deg,
               double maxRange_m = 10)
{
  const auto reading = map.cast(from_m, toward(bearing_deg), maxRange_m);
  return reading ? reading->range_m : -1;
}

TEST(GridmapRanges, ReachTheEdgeOfTheFirstSolidCell)
{
  const GridmapRanges map(room());
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, 0), 1.65, 1e-12);
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, 180), 1.85, 1e-12);
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, -90), 1.85, 1e-12);
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, 90), 1.15, 1e-12) << "the block";
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, 30), 1.65 / std::cos(kPi / 6), 1e-9);
}

TEST(GridmapRanges, NameTheCellThatWasMet)
{
  const GridmapRanges map(room());
  EXPECT_EQ(map.columns(), 16);
  EXPECT_EQ(map.cast({0.1, 0.1}, toward(90), 10)->cell, 8 + 13 * 16);
}

TEST(GridmapRanges, EndAtTheMaximumRangeAndNotBefore)
{
  const GridmapRanges map(room());
  EXPECT_EQ(range_m(map, {0.1, 0.1}, 0, 1.64), -1);
  EXPECT_NEAR(range_m(map, {0.1, 0.1}, 0, 1.66), 1.65, 1e-12);
}

TEST(GridmapRanges, PassUnknownCellsAndLeaveTheMapThroughAGap)
{
  COccupancyGridMap2D open = room();
  open.setCell(15, 8, kUnknown);
  EXPECT_EQ(range_m(GridmapRanges(open), {0.1, 0.1}, 0), -1);
  EXPECT_EQ(range_m(GridmapRanges(open), {5, 5}, 0), -1) << "from outside";
}

TEST(GridmapRanges, AreZeroWithinASolidCell)
{
  EXPECT_EQ(range_m(GridmapRanges(room()), {1.9, 0.1}, 0), 0);
}

/** MRPT's own ray ends within the wall, up to a step along the ray behind its face, and its
 * direction is off by up to 1/819 on each axis. */
TEST(GridmapRanges, AgreeWithMrptsSimulationWithinItsSteps)
{
  COccupancyGridMap2D map(-4, 4, -4, 4, 0.01f);
  map.fill(kFree);
  const int wall = map.x2idx(3.0);
  for (int row = 0; row < static_cast<int>(map.getSizeY()); ++row) map.setCell(wall, row, kSolid);
  const double step_m = raytraceStep_cells(map) * map.getResolution();
  const GridmapRanges ranges(map);
  for (int bearing_deg = -45; bearing_deg <= 45; bearing_deg += 3)
  {
    float mrpt_m = 0;
    bool valid = false;
    map.simulateScanRay(0.005, 0.005, degToRad(bearing_deg), mrpt_m, valid, 20);
    ASSERT_TRUE(valid);
    const double ours_m = range_m(ranges, {0.005, 0.005}, bearing_deg);
    EXPECT_GT(mrpt_m, ours_m - 0.002 * ours_m) << bearing_deg;
    EXPECT_LT(mrpt_m, ours_m + step_m + 0.002 * ours_m) << bearing_deg;
  }
}

TEST(GridmapClearance, IsTheDistanceToTheNearestSolidCell)
{
  const GridmapRanges map(room());
  EXPECT_NEAR(map.clearance_m({1.25, 0}, 2), 0.5, 1e-12) << "the right wall";
  EXPECT_NEAR(map.clearance_m({0.8, 0.95}, 2), std::hypot(0.3, 0.3), 1e-12) << "the block's corner";
  EXPECT_EQ(map.clearance_m({0, 0}, 0.4), 0.4);
  EXPECT_EQ(map.clearance_m({1.9, 0}, 2), 0);
}

TEST(GridmapRoomiestPlace, IsFarFromSolidAndUnknownCells)
{
  COccupancyGridMap2D map = room();
  for (int row = 0; row < 16; ++row)
    for (int column = 8; column < 16; ++column) map.setCell(column, row, kUnknown);
  const Eigen::Vector2d place_m = GridmapRanges(map).roomiestPlace_m();
  EXPECT_NEAR(place_m.x(), -0.875, 0.13) << "the middle of the left half";
  map.fill(kSolid);
  EXPECT_TRUE(
      test::says(test::thrownText<GridmapError>([&] { GridmapRanges(map).roomiestPlace_m(); }),
                 {"no free cell"}));
}

TEST(GridmapOutline, HoldsTheCellsThatOneCanSee)
{
  EXPECT_EQ(GridmapRanges(room()).outline_m().size(), 4 * 14u + 2) << "no corners";
}

class LoadGridmap : public testing::Test
{
 protected:
  void use(const std::string& name) { path_ = folder_.path(name); }

  std::string loadError() const
  {
    return test::thrownText<GridmapError>([this] { loadGridmap(path_); });
  }

  const test::ScratchFolder folder_;
  std::string path_;
};

TEST_F(LoadGridmap, ReadsMrptsGrids)
{
  use("room.gridmap.gz");
  {
    mrpt::io::CFileGZOutputStream file(path_);
    mrpt::serialization::archiveFrom(file) << room();
  }
  EXPECT_NEAR(range_m(loadGridmap(path_), {0.1, 0.1}, 90), 1.15, 1e-12);
}

TEST_F(LoadGridmap, ReadsImagesWithAResolution)
{
  use("room.pgm");  // 8 x 4 pixels, a dark column on the right; the origin is in the middle
  std::ofstream image(path_);
  image << "P2\n8 4\n255\n";
  for (int row = 0; row < 4; ++row) image << "255 255 255 255 255 255 255 0\n";
  image.close();
  const GridmapRanges map = loadImageAsGridmap(path_, 0.5);
  EXPECT_EQ(map.columns(), 8);
  EXPECT_EQ(map.cell_m(), 0.5);
  EXPECT_NEAR(range_m(map, {-0.1, 0.1}, 0), 1.6, 0.51) << "the middle is known to a pixel";
}

TEST_F(LoadGridmap, NamesWhatItCannotRead)
{
  use("absent.gridmap");
  EXPECT_TRUE(test::says(loadError(), {path_, "no such file"}));
  use("foreign.gridmap");
  std::ofstream(path_) << "something else";
  EXPECT_TRUE(test::says(loadError(), {path_, "no MRPT grid map"}));
  use("foreign.png");
  std::ofstream(path_) << "something else";
  EXPECT_TRUE(
      test::says(test::thrownText<GridmapError>([this] { loadImageAsGridmap(path_, 0.05); }),
                 {path_, "cannot be read as an image"}));
}
}  // namespace
}  // namespace psmks
