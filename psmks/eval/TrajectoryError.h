/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <cstddef>

namespace psmks
{
/** The errors of an estimated trajectory at the stamps of the truth. */
struct TrajectoryError
{
  std::size_t poses = 0;  //!< number of compared poses; if it is 0, the errors are NaN
  double mean_m, rms_m, max_m;
  double mean_rad, rms_rad, max_rad;
  double alignedMean_m;  //!< mean error of the position after the best rigid fit, see align()
};

/** The errors of the poses that commonPoses() finds, after laying both trajectories over each other
 * at the first of them. */
TrajectoryError trajectoryError(const Trajectory& estimate, const Trajectory& truth);
}  // namespace psmks
