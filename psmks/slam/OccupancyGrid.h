/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/UniformGrid.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/segmentation/SegmentedScan.h>
#include <psmks/slam/PosedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** What the rays of scans say of the cells of the plane.
 *
 *     S - - - - - - - X ? ?      S sensor, - free: a ray passed, X occupied: a ray ended,
 *                                ? unknown: no ray was there
 *
 * A cell is occupied where more than a quarter of the rays that met it ended in it, and free where
 * fewer did. It is unknown where just a quarter did, too. A ray without a return says nothing. */
class OccupancyGrid
{
 public:
  enum class Cell
  {
    Unknown,
    Free,
    Occupied
  };

  /** @param frame the cells; what lies outside is not kept */
  explicit OccupancyGrid(const UniformGrid& frame);

  /** Adds the valid rays of a scan.
   *  @param scan a cleaned scan, see cleanScan() */
  void add(const SegmentedScan& scan, const Pose2& T_world_sensor);

  Cell at(int column, int row) const;

  const UniformGrid& frame() const { return frame_; }

 private:
  using Evidence = std::int16_t;

  void addRay(const Eigen::Vector2d& from_m, const Eigen::Vector2d& end_m);
  void change(int cell, int by);

  UniformGrid frame_;
  std::vector<Evidence> evidence_;  //!< for occupied above 0, for free below
};

/** The grid of a trajectory, in the frame of the world, from its reference scans at their poses. A
 * cell measures 5 cm, or twice as much, and so on, where there would be more than 33 million cells,
 * which take 67 MB.
 *  @param options by which a ray is valid */
OccupancyGrid makeOccupancyGrid(const std::vector<PosedScan>& scans,
                                const PreprocessingOptions& options);
}  // namespace psmks
