/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace psmks
{
/** A map that cannot be loaded; the text names the file and the reason. */
class GridmapError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** What a laser would measure in an MRPT occupancy grid: exact to the edges of its solid cells.
 *
 * Differs from COccupancyGridMap2D::laserScanSimulator(), which steps along the ray by 0.8 cells
 * (so ranges are too long by up to that step), cuts the direction to 1/819 (50 mm at 20 m; smaller
 * steps make that worse: 2 m at a step of 0.02), shortens the maximum range to 0.8 of it, ignores a
 * mounting upside down, and draws its noise from a generator that the whole process shares. Here
 * the cells that a ray crosses are visited one by one, and noise is the caller's. */
class GridmapRanges
{
 public:
  /** Cells that are free with a lower probability are solid: MRPT's threshold. Unknown ones let a
   * ray pass. */
  static constexpr float kSolidBelow = 0.4f;

  explicit GridmapRanges(const mrpt::maps::COccupancyGridMap2D& map);

  struct Reading
  {
    double range_m;
    int cell;  //!< column + row * columns()
  };

  /** The first solid cell along a ray; none within the range, or beyond the map.
   *  @param direction unit vector
   *  @return range 0 from within a solid cell */
  std::optional<Reading> cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                              double maxRange_m) const;

  /** Distance from a point to the nearest solid cell, but limit_m where that is farther. */
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m) const;

  /** The middle of the free cell that lies farthest from all solid and unknown ones.
   *  @throws GridmapError for a map without a free cell */
  Eigen::Vector2d roomiestPlace_m() const;

  /** Middles of the solid cells that have a neighbour which is not solid: the outlines. */
  std::vector<Eigen::Vector2d> outline_m() const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cell_m() const { return cell_m_; }

 private:
  enum class Cell : unsigned char
  {
    Unknown,
    Free,
    Solid
  };

  bool isInside(const Eigen::Vector2i& cell) const;
  Cell at(const Eigen::Vector2i& cell) const;
  bool isSolid(const Eigen::Vector2i& cell) const;
  Eigen::Vector2i cellOf(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d middle_m(const Eigen::Vector2i& cell) const;

  int columns_, rows_;
  double cell_m_;
  Eigen::Vector2d corner_m_;  //!< of the cell (0, 0)
  std::vector<Cell> cells_;
};

/** Loads an MRPT grid, gzipped or not.
 *  @throws GridmapError */
GridmapRanges loadGridmap(const std::string& path);

/** Loads an image whose dark pixels are solid; its middle is the origin.
 *  @param pixel_m size of a pixel
 *  @throws GridmapError */
GridmapRanges loadImageAsGridmap(const std::string& path, double pixel_m);
}  // namespace psmks
