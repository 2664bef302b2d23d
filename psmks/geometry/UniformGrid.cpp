/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/UniformGrid.h>

#include <cmath>

namespace psmks
{
UniformGrid::UniformGrid(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, double cell_m,
                         int maxCells)
    : low_m_(low_m), cell_m_(cell_m)
{
  const auto count = [this, &low_m, &high_m](int axis)
  { return std::max(1.0, std::ceil((high_m[axis] - low_m[axis]) / cell_m_)); };
  while (count(0) * count(1) > maxCells) cell_m_ *= 2;
  columns_ = static_cast<int>(count(0));
  rows_ = static_cast<int>(count(1));
}
}  // namespace psmks
