/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

#include <Eigen/Core>

namespace psmks
{
/** The relative pose of two scans as well as it can be known: maximum likelihood over the pose and
 * over the unknown lines and circles of the world that both scans see, linearised at the truth.
 *
 * Errors here are estimate minus truth of (x, y, phi) of T_ref_cur, in the axes of the reference:
 * metres, metres, radians.
 *
 * Not a bound on every matcher: corners and ends of walls are not used as points, and neither are
 * lone points. */
struct PoseBound
{
  /** Inverse of the Cramer-Rao bound of the error; singular where the scans leave it open. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /** information * error = pull for the noise that these very scans hold. A scan's noise pulls one
   * way as the current scan and the other way as the reference of the next pair, so that errors
   * along a chain of matches cancel in part. */
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

/** The bound of two scans of known noise, each cast from a sensor at rest.
 *
 * Walls count as lines from 3 rays of both scans together, circles from 4, if each scan has at
 * least one of them; moving objects and lone points do not count. Neither do rays that are off by
 * more than 6 sigma (mixed pixels).
 *  @param noise of the ranges, > 0 */
PoseBound poseBound(const World& world, const Pose2& T_world_ref, const SimulatedScan& reference,
                    const Pose2& T_world_cur, const SimulatedScan& current,
                    const RangeNoise& noise);

/** The error of the maximum likelihood estimate on these very scans, with a motion measured by the
 * wheels as a prior.
 *  @param priorError of the measured motion
 *  @param priorCovariance of it; zero where it is exact */
Eigen::Vector3d mostLikelyError(const PoseBound& bound, const Eigen::Vector3d& priorError,
                                const Eigen::Matrix3d& priorCovariance);
}  // namespace psmks
