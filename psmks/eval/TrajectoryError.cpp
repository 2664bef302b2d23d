/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/ErrorStatistics.h>
#include <psmks/eval/PathErrors.h>
#include <psmks/eval/TrajectoryError.h>

namespace psmks
{
TrajectoryError trajectoryError(const Trajectory& estimate, const Trajectory& truth)
{
  const auto common = commonPoses(estimate, truth);
  const auto errors =
      errorStatistics(absoluteErrors(common, alignAtFirstPose(common)), kSuccessLimit);
  const ErrorStatistics &position = errors.translation_m, &heading = errors.rotation_rad;
  const auto aligned = errorStatistics(absoluteErrors(common, align(common)), kSuccessLimit);
  return {errors.count, position.mean, position.rms, position.max,
          heading.mean, heading.rms,   heading.max,  aligned.translation_m.mean};
}
}  // namespace psmks
