/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <cstddef>
#include <set>
#include <utility>

namespace psmks
{
/** Sharpness of a map without ground truth: the number of cells that the end points of all scans,
 * laid over each other, fall into. The better the poses, the fewer they are.
 *
 *  Counted are valid rays between the two ranges; a point lies in the cell (floor(x / cell),
 *  floor(y / cell)). */
class OccupiedCells
{
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMinRange_m = 0.1;
  static constexpr double kMaxRange_m = 15.0;

  /** @param T_map_sensor pose of the scan's sensor in the frame that the cells lie in */
  void add(const Scan& scan, const Pose2& T_map_sensor);

  std::size_t count() const { return cells_.size(); }

 private:
  SegmentedScan cleaned_;
  std::set<std::pair<int, int>> cells_;
};
}  // namespace psmks
