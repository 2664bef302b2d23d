/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>

namespace psmks
{
/** How good the odometry of a log is, as far as matches have shown: by how much its errors are
 * smaller than the options of OdometryNoise.h allow for. The covariance of a motion has to bear bad
 * wheels where it is the prior of a match. Where odometry alone leads on, with no match to correct
 * it, the same covariance would make a good odometry look lost after a few metres. */
class OdometryQuality
{
 public:
  /** Counts a motion that matches measured, too.
   *  @param measured by the odometry, with a positive definite covariance by the options */
  void learn(const UncertainPose& measured, const Pose2& matched);

  /** The mean square of the errors in standard deviations, at most 1: the factor by which the
   * covariance of a motion of this odometry is smaller than by the options. 1 before the first
   * motion, which counts as ten motions with errors as large as stated. */
  double varianceFactor() const;

 private:
  double sum_ = 0;
  double count_ = 0;
};
}  // namespace psmks
