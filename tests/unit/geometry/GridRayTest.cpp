/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/GridRay.h>

#include <vector>

namespace psmks
{
namespace
{
using Cells = std::vector<int>;

/** The cells that a ray visits, by their numbers:
 *
 *     8  9 10 11
 *     4  5  6  7     cells of 1 m, the lower left corner at the origin
 *     0  1  2  3
 */
Cells visited(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& way_m)
{
  const UniformGrid grid({0, 0}, {4, 3}, 1);
  Cells cells;
  for (GridRay ray(grid, origin_m, way_m.normalized(), way_m.norm()); ray.isInside(); ray.advance())
    cells.push_back(ray.cell());
  return cells;
}
}  // namespace

TEST(GridRay, VisitsEveryCellOnItsWayInOrder)
{
  EXPECT_EQ(visited({0.5, 0.5}, {3, 0}), Cells({0, 1, 2, 3}));
  EXPECT_EQ(visited({3.5, 2.5}, {-3, 0}), Cells({11, 10, 9, 8}));
  EXPECT_EQ(visited({0.5, 0.4}, {2, 2}), Cells({0, 1, 5, 6, 10}));
}

TEST(GridRay, EndsAtItsRangeOrTheBorderOfTheGrid)
{
  EXPECT_EQ(visited({0.5, 0.5}, {0.4, 0}), Cells({0}));
  EXPECT_EQ(visited({2.5, 0.5}, {9, 0}), Cells({2, 3}));
}

TEST(GridRay, BeginsWhereItEntersTheGrid)
{
  EXPECT_EQ(visited({-2, 1.5}, {3.5, 0}), Cells({4, 5}));
  EXPECT_EQ(visited({-2, 1.5}, {0, 3}), Cells());
}
}  // namespace psmks
