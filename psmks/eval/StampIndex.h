/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace psmks
{
/** Largest difference between the stamp of a scan and the same stamp as another program wrote it.
 */
constexpr double kStampTolerance_s = 0.02;

/** Finds the poses of a trajectory by their stamps. The stamps may be in any order, for those of
 * real logs repeat and go backwards. */
class StampIndex
{
 public:
  explicit StampIndex(const Trajectory& trajectory);

  /** The index of the pose with the nearest stamp; of equally near ones the first in the
   * trajectory. Nothing if it is farther away than the tolerance. */
  std::optional<std::size_t> nearest(double stamp_s, double tolerance_s) const;

 private:
  struct Entry
  {
    double stamp_s;
    std::size_t pose;
  };
  std::vector<Entry> entries_;  //!< sorted by stamp; equal stamps in the order of the trajectory
};
}  // namespace psmks
