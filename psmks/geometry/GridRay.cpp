/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/GridRay.h>

#include <cmath>
#include <limits>

namespace psmks
{
GridRay::GridRay(const UniformGrid& grid, const Eigen::Vector2d& origin_m,
                 const Eigen::Vector2d& direction, double maxRange_m)
    : grid_(grid), end_m_(maxRange_m)
{
  for (const int axis : {0, 1}) clip(axis, origin_m[axis], direction[axis]);
  inside_ = begin_m_ <= end_m_;
  if (!inside_) return;
  const Eigen::Vector2d entry_m = origin_m + begin_m_ * direction;
  axes_[0] = startAxis(0, grid.column(entry_m.x()), origin_m.x(), direction.x());
  axes_[1] = startAxis(1, grid.row(entry_m.y()), origin_m.y(), direction.y());
}

/** Cuts the ray to the part between the two borders of the grid on one axis. */
void GridRay::clip(int axis, double origin_m, double slope)
{
  const double low_m = grid_.low_m()[axis] - origin_m, high_m = grid_.high_m()[axis] - origin_m;
  if (slope == 0)
  {
    if (low_m > 0 || high_m < 0) end_m_ = -1;
    return;
  }
  begin_m_ = std::max(begin_m_, (slope > 0 ? low_m : high_m) / slope);
  end_m_ = std::min(end_m_, (slope > 0 ? high_m : low_m) / slope);
}

GridRay::Axis GridRay::startAxis(int axis, int index, double origin_m, double slope) const
{
  /** Where a ray meets a border that it runs along. Definition: never. */
  constexpr double kNever_m = std::numeric_limits<double>::infinity();
  const int count = axis == 0 ? grid_.columns() : grid_.rows();
  if (slope == 0) return {index, 0, count, kNever_m, kNever_m};
  const int step = slope > 0 ? 1 : -1;
  const int border = slope > 0 ? index + 1 : index;
  const double border_m = grid_.low_m()[axis] + border * grid_.cell_m();
  return {index, step, count, (border_m - origin_m) / slope, grid_.cell_m() / std::abs(slope)};
}
}  // namespace psmks
