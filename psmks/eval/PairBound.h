/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Pose2.h>
#include <psmks/core/Scan.h>

#include <Eigen/Core>

namespace psmks
{
/** How well the relative pose of two scans can be known: the Cramer-Rao bound with the lines of the
 * world as unknowns, both scans noisy, at the true pose.
 *
 * It needs no map of the world, so that it can be had for measured scans too: the lines are those
 * that the scans themselves show once they lie on each other. */
struct PairBound
{
  /** Inverse of the bound of the error (x, y, phi) of T_ref_cur in the axes of the reference: m, m,
   * rad. Singular where the scans leave it open. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/** @param rangeSigma_m noise of a range, > 0 */
PairBound pairBound(const Scan& reference, const Scan& current, const Pose2& T_ref_cur_true,
                    double rangeSigma_m);
}  // namespace psmks
