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
/** A measure of the sharpness of a map that needs no ground truth: the number of cells that hold an
 * end point of any scan. The better the poses fit together, the fewer cells are occupied.
 *
 * Only valid rays between the two ranges are counted. A point lies in the cell (floor(x / cell),
 * floor(y / cell)). */
class OccupiedCells
{
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMinRange_m = 0.1;
  static constexpr double kMaxRange_m = 15.0;

  /** Adds a scan.
   *  @param T_map_sensor pose of its sensor in the frame of the cells */
  void add(const Scan& scan, const Pose2& T_map_sensor);

  std::size_t count() const { return cells_.size(); }

 private:
  SegmentedScan cleaned_;
  std::set<std::pair<int, int>> cells_;
};
}  // namespace psmks
