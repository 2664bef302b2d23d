/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace psmks
{
/** A stamp that another program wrote counts as that of a scan up to so far away. */
constexpr double kStampTolerance_s = 0.02;

/** Finds the poses of a trajectory by their stamps, whose order does not matter: those of real logs
 *  repeat and go backwards. */
class StampIndex
{
 public:
  explicit StampIndex(const Trajectory& trajectory);

  /** The pose whose stamp is nearest; of equally near ones that which stands first in the
   *  trajectory. None where it is further away than the tolerance. */
  std::optional<std::size_t> nearest(double stamp_s, double tolerance_s) const;

 private:
  struct Entry
  {
    double stamp_s;
    std::size_t pose;
  };
  std::vector<Entry> entries_;  // by stamp, equal ones in the order of the trajectory
};
}  // namespace psmks
