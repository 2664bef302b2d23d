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
/** A map that cannot be loaded or used. The text names the reason, and the file where there is one.
 */
class GridmapError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** What a laser without noise would measure in an MRPT occupancy grid. Ranges end exactly at the
 *  edges of solid cells, because the cells that a ray crosses are visited one by one.
 *
 * COccupancyGridMap2D::laserScanSimulator() of MRPT 2 does less:
 *  - It steps along the ray by 0.8 cells, so that ranges are too long by up to one step.
 *  - It rounds the direction to 1/819, which moves the end of a ray of 20 m by up to 50 mm; with
 *    smaller steps by more, up to 2 m with steps of 0.02 cells.
 *  - It shortens the maximum range to 0.8 of it.
 *  - It ignores that a scanner hangs upside down.
 *  - It draws noise from a generator that the whole process shares.
 *
 * A const object serves several threads. */
class GridmapRanges
{
 public:
  /** A cell that is free with a lower probability is solid, as in MRPT. A cell that is neither
   *  solid nor free is unknown: it lets a ray pass. */
  static constexpr float kSolidBelow = 0.4f;

  /** Copies the cells of the map. */
  explicit GridmapRanges(const mrpt::maps::COccupancyGridMap2D& map);

  /** What a ray met. */
  struct Reading
  {
    double range_m;
    int cell;  //!< column + row * columns()
  };

  /** The first solid cell along a ray.
   *  @param origin_m where the ray begins, in the frame of the map
   *  @param direction unit vector
   *  @return none where the ray meets no solid cell nearer than maxRange_m, or begins outside the
   *  map; a range of 0 where it begins in a solid cell */
  std::optional<Reading> cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                              double maxRange_m) const;

  /** Distance from a point to the nearest edge of a solid cell, at most limit_m; 0 within a solid
   *  cell. */
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m) const;

  /** The middle of the free cell that lies farthest from all solid and unknown cells.
   *  @throws GridmapError for a map without a free cell */
  Eigen::Vector2d roomiestPlace_m() const;

  /** Middles of the solid cells that have a neighbour, of four, which is not solid: the outlines of
   *  what stands in the map. */
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

/** Loads an MRPT occupancy grid from a file, gzipped or not.
 *  @throws GridmapError for a file that is missing, damaged or of another kind */
GridmapRanges loadGridmap(const std::string& path);

/** Loads an image whose dark pixels are solid. The middle of the image is the origin.
 *  @param pixel_m size of a pixel
 *  @throws GridmapError for a file that cannot be read as an image */
GridmapRanges loadImageAsGridmap(const std::string& path, double pixel_m);
}  // namespace psmks
