/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Simulation.h>
#include <psmks/sim/World.h>

#include <Eigen/Core>
#include <optional>

namespace psmks
{
/** The relative pose of two scans as well as it can be known: maximum likelihood over the pose and
 * over the unknown lines and circles of the world that both scans see (at least three rays together
 * in each, see docs/algorithm.md, "Drift floor"), linearised at the truth. */
struct PoseBound
{
  /** Inverse of the Cramer-Rao bound of (x, y, phi) of T_ref_cur, in reference axes. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /** Gradient: information * error = pull, with the noise that these very scans hold. */
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

/** The bound of two scans of known noise. */
PoseBound poseBound(const World& world, const Pose2& T_world_ref, const SimulatedScan& reference,
                    const Pose2& T_world_cur, const SimulatedScan& current, double rangeSigma_m);

/** The error (x, y, phi) of the maximum likelihood estimate of T_ref_cur on these very scans, with
 * a motion measured by the wheels as a prior.
 *  @param priorError estimate minus truth of the measured motion, reference axes
 *  @param priorCovariance of it */
Eigen::Vector3d mostLikelyError(const PoseBound& bound, const Eigen::Vector3d& priorError,
                                const Eigen::Matrix3d& priorCovariance);
}  // namespace psmks
