/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/UniformGrid.h>

namespace psmks
{
TEST(UniformGrid, CoversTheRectangleWithCellsOfTheAskedSize)
{
  const UniformGrid grid({-1, 2}, {1.1, 3}, 0.5);
  EXPECT_EQ(grid.columns(), 5);
  EXPECT_EQ(grid.rows(), 2);
  EXPECT_EQ(grid.cells(), 10);
  EXPECT_EQ(grid.centre_m(0, 1), Eigen::Vector2d(-0.75, 2.75));
  EXPECT_EQ(grid.high_m(), Eigen::Vector2d(1.5, 3));
}

TEST(UniformGrid, PlacesOutsideBelongToTheNearestCell)
{
  const UniformGrid grid({0, 0}, {4, 3}, 1);
  EXPECT_EQ(grid.column(-9), 0);
  EXPECT_EQ(grid.column(2.5), 2);
  EXPECT_EQ(grid.row(9), 2);
}

TEST(UniformGrid, CellsDoubleUntilTheyAreFewEnough)
{
  const UniformGrid grid({0, 0}, {100, 100}, 1, 1000);
  EXPECT_EQ(grid.cell_m(), 4);
  EXPECT_EQ(grid.cells(), 625);
}
}  // namespace psmks
