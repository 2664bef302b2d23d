/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

#include <Eigen/Core>

namespace psmks
{
/** The Cramer-Rao bound of the relative pose of two simulated scans. The likelihood is that of the
 * pose together with the unknown lines and circles that both scans see, linearised at the truth.
 *
 * Errors are estimate minus truth of (x, y, phi) of T_ref_cur, in the axes of the reference:
 * metres, metres, radians.
 *
 * A matcher can be better than this bound, for corners, ends of walls and isolated points are not
 * used as landmarks. */
struct PoseBound
{
  /** The inverse of the covariance bound. It is singular in directions that the scans do not
   * constrain. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /** The right hand side of information * error = pull for the actual noise of the two scans. The
   * noise of a scan pulls in one direction when the scan is the current one and in the other
   * direction when it is the reference of the next pair, so that errors along a chain of matches
   * cancel in part. */
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

/** The bound of two scans, each cast from a sensor at rest, whose noise is known.
 *
 * A wall counts if both scans together have at least 3 rays on it, a circle with at least 4, and
 * each scan at least one. Moving objects and isolated points do not count, nor do rays whose error
 * exceeds 6 sigma (mixed pixels).
 *  @param noise of the ranges, > 0 */
PoseBound poseBound(const World& world, const Pose2& T_world_ref, const SimulatedScan& reference,
                    const Pose2& T_world_cur, const SimulatedScan& current,
                    const RangeNoise& noise);

/** The error of the maximum likelihood estimate from the two scans with their actual noise and a
 * motion measured by the wheels as a prior.
 *  @param priorError error of the measured motion
 *  @param priorCovariance covariance of the measured motion; zero if it is exact */
Eigen::Vector3d mostLikelyError(const PoseBound& bound, const Eigen::Vector3d& priorError,
                                const Eigen::Matrix3d& priorCovariance);
}  // namespace psmks
