/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/joint/EvidenceGrid.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <algorithm>
#include <vector>

namespace psmks
{
namespace
{
constexpr double kTolerance_m = 0.04;

/** The features of a scan of some walls from the origin. */
struct View
{
  View(const std::vector<Wall>& walls, const BeamGrid& beams, double maxRange_m = 30)
      : scan(segmentByWalls(castScan(walls, {}, beams, maxRange_m), walls, {}))
  {
    features.build(scan);
  }

  View(const View&) = delete;
  View& operator=(const View&) = delete;

  SegmentedScan scan;
  ScanFeatures features;
};

/** Cells by column and row, from that of the smallest index that a search asks for to the largest.
 */
class Cells
{
 public:
  /** @param extent_m beyond which, in either axis, no place has an index */
  Cells(const EvidenceGrid& grid, double extent_m) : grid_(grid)
  {
    int least = -1, most = -1;
    const double step_m = 0.9 * grid.cell_m();
    for (double x_m = -extent_m; x_m <= extent_m; x_m += step_m)
      for (double y_m = -extent_m; y_m <= extent_m; y_m += step_m)
      {
        const int index = grid.indexOf(static_cast<float>(x_m), static_cast<float>(y_m));
        if (index < 0) continue;
        least = least < 0 ? index : std::min(least, index);
        most = std::max(most, index);
      }
    const int perRow = grid.offset(0, 1);
    reach_ = least % perRow;
    EXPECT_EQ(least / perRow, reach_) << "the same in both axes";
    columns_ = most % perRow + reach_;
    rows_ = most / perRow + reach_;
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  int at(int level, int column, int row) const
  {
    return grid_.level(level)[grid_.offset(column, row)];
  }

  /** The highest evidence of a square of cells, one by one. */
  int highest(int column, int row, int side) const
  {
    int value = at(0, column, row);
    for (int r = row; r < row + side; ++r)
      for (int c = column; c < column + side; ++c) value = std::max(value, at(0, c, r));
    return value;
  }

 private:
  const EvidenceGrid& grid_;
  int columns_ = 0, rows_ = 0, reach_ = 0;
};

void expectBoundsOfSquares(const Cells& cells)
{
  for (int h = 0; h < EvidenceGrid::kLevels; ++h)
  {
    int wrong = 0;
    for (int row = 0; row < cells.rows(); ++row)
      for (int column = 0; column < cells.columns(); ++column)
        wrong += cells.at(h, column, row) != cells.highest(column, row, 1 << h);
    EXPECT_EQ(wrong, 0) << "level " << h << " of " << cells.columns() << " x " << cells.rows();
  }
}

//  y =  3  +-----------+                A room with a recess that the scanner o cannot see into,
//  and
//          |           | recess         a person P before the wall at x = 5. The scanner sees 270
//       1  |           +-------+        degrees: nothing to its left in the sketch, that is behind
//          |     o>        P   |        it, from bearing 135 to 225 degrees.
//      -2  +-------------------+
//         -3           2       5 = x
class EvidenceOfARoom : public testing::Test
{
 protected:
  static std::vector<Wall> room()
  {
    std::vector<Wall> walls = outline({{-3, -2}, {5, -2}, {5, 1}, {2, 1}, {2, 3}, {-3, 3}});
    for (const Wall& side : box({3.2, -0.5}, 0.3, 0.3)) walls.push_back(side);
    return walls;
  }

  EvidenceOfARoom() { grid_.build(view_.features, kReach_m, kTolerance_m); }

  int evidenceAt(double x_m, double y_m) const
  {
    const int index = grid_.indexOf(static_cast<float>(x_m), static_cast<float>(y_m));
    EXPECT_GE(index, 0) << x_m << ' ' << y_m;
    return index < 0 ? 99 : grid_.level(0)[index];
  }

  /** The middle of the cell of a place along one axis, to half a millimetre.
   *  @param isSame whether a place so far along the axis is in the cell */
  template <class IsSame>
  static double middle_m(double place_m, const IsSame& isSame)
  {
    constexpr double kStep_m = 0.0005;
    double low_m = place_m, high_m = place_m;
    while (isSame(low_m - kStep_m)) low_m -= kStep_m;
    while (isSame(high_m + kStep_m)) high_m += kStep_m;
    return (low_m + high_m) / 2;
  }

  Eigen::Vector2d middleOfCell(double x_m, double y_m) const
  {
    const auto indexAt = [&](double x, double y)
    { return grid_.indexOf(static_cast<float>(x), static_cast<float>(y)); };
    const int index = indexAt(x_m, y_m);
    return {middle_m(x_m, [&](double x) { return indexAt(x, y_m) == index; }),
            middle_m(y_m, [&](double y) { return indexAt(x_m, y) == index; })};
  }

  static constexpr double kReach_m = 1.5;
  View view_{room(), BeamGrid::centered(degToRad(270), 541)};
  EvidenceGrid grid_;
};
}  // namespace

TEST_F(EvidenceOfARoom, OnWallsItIsThatOfARayOnASurface)
{
  EXPECT_DOUBLE_EQ(grid_.cell_m(), 0.1);
  for (const auto& [x_m, y_m] : {std::pair{5.0, 0.4}, {1.0, 3.0}, {0.0, -2.0}, {2.0, 2.0}})
    EXPECT_EQ(evidenceAt(x_m, y_m), EvidenceGrid::kOnSurface) << x_m << ' ' << y_m;
  EXPECT_EQ(evidenceAt(3.05, -0.5), EvidenceGrid::kOnSurface) << "on the person";
}

// The order is that of logLikelihoodRatio(): free space tells most, what may have been hidden less,
// behind an object that may have moved least.
TEST_F(EvidenceOfARoom, InFrontBehindAndWhereAnObjectMovedItIsAgainst)
{
  const int front = evidenceAt(1.5, 0), behind = evidenceAt(4, 2.5);
  const int uncovered = evidenceAt(4.3, -0.5 * 4.3 / 3.2);
  EXPECT_EQ(evidenceAt(0.5, 2), front);
  EXPECT_EQ(evidenceAt(3, 1.5), behind);
  EXPECT_LT(front, behind);
  EXPECT_LT(behind, uncovered);
  EXPECT_LT(uncovered, 0);
}

TEST_F(EvidenceOfARoom, WhereNothingIsKnownItSaysNothing)
{
  EXPECT_EQ(evidenceAt(-2, 0), 0) << "outside the field of view";
  EXPECT_EQ(evidenceAt(-2.9, 0.5), 0);
  EXPECT_EQ(evidenceAt(6, 0), 0) << "beyond the rectangle about the points";
  EXPECT_EQ(evidenceAt(0, 4), 0);
}

// Within the tolerance and a cell of a surface, from the middle of the cell: countRays() says it of
// a point there.
TEST_F(EvidenceOfARoom, ItIsThatOfTheOutcomeInTheMiddleOfTheCell)
{
  test::RandomNumbers random(31);
  SCOPED_TRACE(random.seedText());
  const int front = evidenceAt(1.5, 0), behind = evidenceAt(4, 2.5);
  const int uncovered = evidenceAt(4.3, -0.5 * 4.3 / 3.2);
  RayPoints point;
  point.x_m = {0}, point.y_m = {0}, point.movable = {0}, point.looks = {1};
  int clear = 0;
  for (int i = 0; i < 500; ++i)
  {
    const double x_m = random.uniform(-2.8, 4.9), y_m = random.uniform(-1.9, 2.9);
    const Eigen::Vector2d middle_m = middleOfCell(x_m, y_m);
    const auto expected = [&](double tolerance_m, double right_m, double up_m)
    {
      point.x_m[0] = static_cast<float>(middle_m.x() + right_m);
      point.y_m[0] = static_cast<float>(middle_m.y() + up_m);
      const RayCounts n =
          countRays(point, view_.features.surface, {}, static_cast<float>(tolerance_m));
      return static_cast<int>(
          n.on * EvidenceGrid::kOnSurface + n.front * static_cast<float>(front) +
          n.behind * static_cast<float>(behind) + n.uncovered * static_cast<float>(uncovered));
    };
    // Half a millimetre, of the middle, may decide nothing.
    const double tolerance_m = kTolerance_m + grid_.cell_m(), little_m = 0.001;
    const int outcome = expected(tolerance_m, 0, 0);
    bool isClear = true;
    for (const auto& [right_m, up_m] :
         {std::pair{little_m, 0.0}, {-little_m, 0.0}, {0.0, little_m}, {0.0, -little_m}})
      isClear = isClear && expected(tolerance_m - little_m, right_m, up_m) == outcome &&
                expected(tolerance_m + little_m, right_m, up_m) == outcome;
    if (!isClear) continue;
    ++clear;
    EXPECT_EQ(evidenceAt(x_m, y_m), outcome) << x_m << ' ' << y_m;
  }
  EXPECT_GT(clear, 450);
}

TEST_F(EvidenceOfARoom, PlacesWithinTheReachHaveACellAndThoseBeyondHaveNone)
{
  const auto has = [&](double x_m, double y_m)
  { return grid_.indexOf(static_cast<float>(x_m), static_cast<float>(y_m)) >= 0; };
  constexpr double kALittle_m = 0.01;
  // The reach is rounded up to whole cells, with one or two besides.
  const double cells_m = 4 * grid_.cell_m();
  for (const double y_m : {-1.0, 0.0, 2.0})
  {
    EXPECT_TRUE(has(5 + kReach_m - kALittle_m, y_m) && has(-3 - kReach_m + kALittle_m, y_m));
    EXPECT_FALSE(has(5 + kReach_m + cells_m, y_m) || has(-3 - kReach_m - cells_m, y_m));
  }
  for (const double x_m : {-2.0, 0.0, 4.0})
  {
    EXPECT_TRUE(has(x_m, 3 + kReach_m - kALittle_m) && has(x_m, -2 - kReach_m + kALittle_m));
    EXPECT_FALSE(has(x_m, 3 + kReach_m + cells_m) || has(x_m, -2 - kReach_m - cells_m));
  }
  for (const double far_m : {100.0, 1e6, 1e12})
    EXPECT_FALSE(has(far_m, 0) || has(-far_m, 0) || has(0, far_m) || has(0, -far_m)) << far_m;
}

// A place one cell beside is one index away, one above a row.
TEST_F(EvidenceOfARoom, OffsetsLeadToTheCellsBeside)
{
  const auto cell = static_cast<float>(grid_.cell_m());
  const int index = grid_.indexOf(0.52f, 0.31f);
  EXPECT_EQ(grid_.indexOf(0.52f + 7 * cell, 0.31f - 3 * cell), index + grid_.offset(7, -3));
  EXPECT_EQ(grid_.offset(0, 0), 0);
}

TEST_F(EvidenceOfARoom, ALevelIsTheHighestEvidenceOfItsSquare)
{
  expectBoundsOfSquares(Cells(grid_, 8));
}

// ---- random, large and small scans --------------------------------------------------------------

TEST(EvidenceGrid, LevelsBoundTheSquaresOfAnyScan)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    test::RandomNumbers random(seed);
    SCOPED_TRACE(random.seedText());
    const View view(clutteredRoom(seed),
                    BeamGrid::centered(random.uniform(1, 2 * kPi), random.integer(20, 400)),
                    random.uniform(3, 12));
    EvidenceGrid grid;
    grid.build(view.features, random.uniform(0, 2), kTolerance_m);
    expectBoundsOfSquares(Cells(grid, 12));
  }
}

//  +--------------------+
//  |         o          |    a hall of 60 x 60 m: 360,000 cells of 10 cm are too many
//  +--------------------+
TEST(EvidenceGrid, AVeryLargeScanHasCoarserCells)
{
  const BeamGrid around = BeamGrid::centered(2 * kPi, 720);
  const View hall(box({0, 0}, 60, 60), around, 80), room(squareRoom(), around);
  EvidenceGrid coarse, fine;
  coarse.build(hall.features, 5, kTolerance_m);
  fine.build(room.features, 5, kTolerance_m);
  EXPECT_DOUBLE_EQ(fine.cell_m(), 0.1);
  EXPECT_GT(coarse.cell_m(), 0.12);
  EXPECT_LT(coarse.cell_m(), 0.4);
  const auto at = [&](float x_m, float y_m) { return coarse.level(0)[coarse.indexOf(x_m, y_m)]; };
  EXPECT_EQ(at(30, 3), EvidenceGrid::kOnSurface);
  EXPECT_EQ(at(-30, -20), EvidenceGrid::kOnSurface);
  EXPECT_LT(at(10, 4), 0) << "free space";
  EXPECT_GE(coarse.indexOf(34.9f, 34.9f), 0);
  EXPECT_EQ(coarse.indexOf(40, 0), -1);
  expectBoundsOfSquares(Cells(coarse, 45));
}

TEST(EvidenceGrid, AScanWithoutReturnsKnowsNothing)
{
  const View nothing({}, BeamGrid::centered(2 * kPi, 360));
  EvidenceGrid grid;
  grid.build(nothing.features, 1, kTolerance_m);
  const Cells cells(grid, 5);
  for (int h = 0; h < EvidenceGrid::kLevels; ++h)
    for (int row = 0; row < cells.rows(); ++row)
      for (int column = 0; column < cells.columns(); ++column)
        ASSERT_EQ(cells.at(h, column, row), 0) << h << ' ' << column << ' ' << row;
}

TEST(EvidenceGrid, AScanLeavesNothingBehindForTheNext)
{
  const BeamGrid around = BeamGrid::centered(2 * kPi, 360);
  const View hall(box({0, 0}, 60, 60), around, 80), room(officeRoom(), around);
  const View corner(box({1, 1}, 3, 2), BeamGrid::centered(kPi, 91));
  EvidenceGrid used;
  used.reserve();
  for (const View* view : {&hall, &room, &corner, &room, &hall})
  {
    used.build(view->features, 1.3, kTolerance_m);
    EvidenceGrid fresh;
    fresh.build(view->features, 1.3, kTolerance_m);
    ASSERT_EQ(used.cell_m(), fresh.cell_m());
    const Cells a(used, 35), b(fresh, 35);
    ASSERT_EQ(a.columns(), b.columns());
    ASSERT_EQ(a.rows(), b.rows());
    int different = 0;
    for (int h = 0; h < EvidenceGrid::kLevels; ++h)
      for (int row = 0; row < a.rows(); ++row)
        for (int column = 0; column < a.columns(); ++column)
          different += a.at(h, column, row) != b.at(h, column, row);
    EXPECT_EQ(different, 0);
  }
}
}  // namespace psmks
