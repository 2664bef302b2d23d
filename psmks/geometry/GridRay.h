/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UniformGrid.h>

#include <array>

namespace psmks
{
/** Visits the cells of a grid along a ray in their order (Amanatides and Woo 1987). */
class GridRay
{
 public:
  /** Begins at the first cell of the grid on the ray. The origin may lie outside the grid.
   *  @param direction unit vector */
  GridRay(const UniformGrid& grid, const Eigen::Vector2d& origin_m,
          const Eigen::Vector2d& direction, double maxRange_m);

  /** Whether there is a present cell. It is false after the ray has left the grid or reached its
   * range, and if it never meets the grid. */
  bool isInside() const { return inside_; }

  int cell() const { return grid_.cell(axes_[0].index, axes_[1].index); }

  /** The range at which the ray leaves the present cell. */
  double exit_m() const { return std::min(axes_[0].next_m, axes_[1].next_m); }

  void advance()
  {
    Axis& axis = axes_[0].next_m < axes_[1].next_m ? axes_[0] : axes_[1];
    inside_ = axis.next_m <= end_m_;
    axis.index += axis.step;
    axis.next_m += axis.pitch_m;
    inside_ = inside_ && axis.index >= 0 && axis.index < axis.count;
  }

 private:
  struct Axis
  {
    int index = 0, step = 0, count = 0;
    double next_m = 0;   //!< range at the next border of a cell
    double pitch_m = 0;  //!< difference of range between two borders
  };

  void clip(int axis, double origin_m, double slope);
  Axis startAxis(int axis, int index, double origin_m, double slope) const;

  const UniformGrid& grid_;
  std::array<Axis, 2> axes_;
  double begin_m_ = 0, end_m_;  //!< ranges at which it enters and leaves the grid
  bool inside_ = true;
};
}  // namespace psmks
