/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace psmks
{
/** A rectangle of the plane that is divided into square cells, numbered row by row. */
class UniformGrid
{
 public:
  /** Makes a grid of one cell at the origin. */
  UniformGrid() = default;

  /** Makes a grid that covers the rectangle between two corners.
   *  @param cell_m least size of a cell; doubled until there are at most maxCells */
  UniformGrid(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, double cell_m,
              int maxCells = kMaxCells);

  /** Most cells of a grid. Unit: cells. Definition: they take some tens of megabytes. */
  static constexpr int kMaxCells = 1 << 22;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int cells() const { return columns_ * rows_; }
  double cell_m() const { return cell_m_; }
  int cell(int column, int row) const { return row * columns_ + column; }

  const Eigen::Vector2d& low_m() const { return low_m_; }
  Eigen::Vector2d high_m() const { return low_m_ + cell_m_ * Eigen::Vector2d(columns_, rows_); }

  /** The centre of a cell. */
  Eigen::Vector2d centre_m(int column, int row) const
  {
    return low_m_ + cell_m_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  }

  /** The column of a place, or the nearest one if the place is outside the grid. */
  int column(double x_m) const { return clamped((x_m - low_m_.x()) / cell_m_, columns_); }
  int row(double y_m) const { return clamped((y_m - low_m_.y()) / cell_m_, rows_); }

 private:
  static int clamped(double position, int count)
  {
    return static_cast<int>(std::clamp(position, 0.0, count - 1.0));
  }

  Eigen::Vector2d low_m_ = Eigen::Vector2d::Constant(-0.5);
  double cell_m_ = 1;
  int columns_ = 1, rows_ = 1;
};
}  // namespace psmks
