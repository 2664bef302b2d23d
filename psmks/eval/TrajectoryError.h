/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <cstddef>

namespace psmks
{
/** Errors of an estimated trajectory at the stamps of the truth's that it covers. */
struct TrajectoryError
{
  std::size_t poses = 0;  //!< that could be compared; the rest is NaN where there are none
  double mean_m, rms_m, max_m;
  double mean_rad, rms_rad, max_rad;
};

/** Of the poses that commonPoses() finds, laid over each other at the first of them. */
TrajectoryError trajectoryError(const Trajectory& estimate, const Trajectory& truth);
}  // namespace psmks
