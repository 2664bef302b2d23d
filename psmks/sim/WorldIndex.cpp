/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/GridRay.h>
#include <psmks/sim/WorldIndex.h>

#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
// Cells are enlarged by this margin, so that no object on a border is lost to rounding.
constexpr double kMargin_m = 1e-6;

UniformGrid gridAround(const World& world)
{
  if (world.walls().empty() && world.points().empty()) return UniformGrid();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Eigen::Vector2d low_m(kFar, kFar), high_m(-kFar, -kFar);
  const auto include = [&low_m, &high_m](const Eigen::Vector2d& point_m, double radius_m)
  {
    low_m = low_m.cwiseMin(point_m - Eigen::Vector2d::Constant(radius_m));
    high_m = high_m.cwiseMax(point_m + Eigen::Vector2d::Constant(radius_m));
  };
  for (const World::Wall& wall : world.walls())
    for (const Eigen::Vector2d& end_m : {wall.a, wall.b}) include(end_m, kMargin_m);
  for (const World::Point& point : world.points())
    include(point.centre_m, World::kPointRadius_m + kMargin_m);
  return UniformGrid(low_m, high_m, WorldIndex::kCell_m);
}

/** Calls visit(column, row) for the cells of the rectangle between two corners. */
template <typename Visit>
void forCellsBetween(const UniformGrid& grid, const Eigen::Vector2d& low_m,
                     const Eigen::Vector2d& high_m, const Visit& visit)
{
  for (int row = grid.row(low_m.y()); row <= grid.row(high_m.y()); ++row)
    for (int column = grid.column(low_m.x()); column <= grid.column(high_m.x()); ++column)
      visit(column, row);
}

/** Whether the line of a wall passes through a square: the distance from the centre to the line is
 * then at most the half width of the square across the line. */
bool lineMeetsSquare(const World::Wall& wall, const Eigen::Vector2d& centre_m, double half_m)
{
  const Eigen::Vector2d along = wall.b - wall.a, toCentre = centre_m - wall.a;
  const double across = along.x() * toCentre.y() - along.y() * toCentre.x();
  return std::abs(across) <= half_m * along.lpNorm<1>();
}

std::vector<CellLists<int>::Entry> wallsOfCells(const World& world, const UniformGrid& grid)
{
  std::vector<CellLists<int>::Entry> entries;
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(kMargin_m);
  for (std::size_t w = 0; w < world.walls().size(); ++w)
  {
    const World::Wall& wall = world.walls()[w];
    const auto enter = [&](int column, int row)
    {
      if (lineMeetsSquare(wall, grid.centre_m(column, row), grid.cell_m() / 2 + kMargin_m))
        entries.push_back({grid.cell(column, row), static_cast<int>(w)});
    };
    forCellsBetween(grid, wall.a.cwiseMin(wall.b) - margin_m, wall.a.cwiseMax(wall.b) + margin_m,
                    enter);
  }
  return entries;
}

std::vector<CellLists<World::Point>::Entry> pointsOfCells(const World& world,
                                                          const UniformGrid& grid)
{
  std::vector<CellLists<World::Point>::Entry> entries;
  const Eigen::Vector2d reach_m = Eigen::Vector2d::Constant(World::kPointRadius_m + kMargin_m);
  for (const World::Point& point : world.points())
  {
    const auto enter = [&](int column, int row) {
      entries.push_back({grid.cell(column, row), point});
    };
    forCellsBetween(grid, point.centre_m - reach_m, point.centre_m + reach_m, enter);
  }
  return entries;
}
}  // namespace

WorldIndex::WorldIndex(World world)
    : world_(std::move(world)),
      grid_(gridAround(world_)),
      walls_(grid_.cells(), wallsOfCells(world_, grid_)),
      points_(grid_.cells(), pointsOfCells(world_, grid_))
{
}

Hit WorldIndex::cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                     double maxRange_m, double time_s) const
{
  Hit nearest{maxRange_m, Hit::kNothing};
  for (GridRay ray(grid_, origin_m, direction, maxRange_m); ray.isInside(); ray.advance())
  {
    castInCell(ray.cell(), origin_m, direction, nearest);
    if (nearest.range_m < ray.exit_m()) break;
  }
  return world_.castAtMoving(origin_m, direction, nearest, time_s);
}

void WorldIndex::castInCell(int cell, const Eigen::Vector2d& origin_m,
                            const Eigen::Vector2d& direction, Hit& nearest) const
{
  for (const int w : walls_[cell])
    nearest.take(world_.walls()[static_cast<std::size_t>(w)].rangeAlong_m(origin_m, direction), w);
  for (const World::Point& point : points_[cell])
    nearest.take(point.disc().rangeAlong_m(origin_m, direction), world_.objectOf(point));
}

// Visits rings of cells around the cell of the point, or around the nearest cell if the point is
// outside the grid. Objects that are not in the first n + 1 rings are at least n cells away.
double WorldIndex::clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const
{
  double nearest_m = limit_m;
  const int column = grid_.column(point_m.x()), row = grid_.row(point_m.y());
  const int rings = std::max(grid_.columns(), grid_.rows());
  for (int ring = 0; ring < rings && nearest_m > (ring - 1) * grid_.cell_m(); ++ring)
    nearest_m = std::min(nearest_m, clearanceInRing_m(column, row, ring, point_m));
  return world_.clearanceOfMoving_m(point_m, nearest_m, time_s);
}

double WorldIndex::clearanceInRing_m(int column, int row, int ring,
                                     const Eigen::Vector2d& point_m) const
{
  double nearest_m = std::numeric_limits<double>::infinity();
  const int lastRow = std::min(row + ring, grid_.rows() - 1);
  for (int r = std::max(row - ring, 0); r <= lastRow; ++r)
  {
    const bool wholeRow = std::abs(r - row) == ring;
    for (int c = column - ring; c <= column + ring; c += wholeRow ? 1 : 2 * ring)
      if (c >= 0 && c < grid_.columns())
        nearest_m = std::min(nearest_m, clearanceInCell_m(grid_.cell(c, r), point_m));
  }
  return nearest_m;
}

double WorldIndex::clearanceInCell_m(int cell, const Eigen::Vector2d& point_m) const
{
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const int w : walls_[cell])
    nearest_m =
        std::min(nearest_m, world_.walls()[static_cast<std::size_t>(w)].distance_m(point_m));
  for (const World::Point& point : points_[cell])
    nearest_m = std::min(nearest_m, point.disc().distance_m(point_m));
  return nearest_m;
}
}  // namespace psmks
