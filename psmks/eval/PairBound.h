/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairError.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/RangeNoise.h>
#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** The Cramer-Rao bound of the relative pose of two noisy scans, with the lines and circles of the
 * world as further unknowns, linearised at the true pose.
 *
 * It needs no map of the world and can be computed for real scans too: the lines are found in the
 * scans themselves after they are laid over each other at the true pose. Walls on which neither
 * scan has 3 rays, circles that only one scan shows, ends and corners are left out. The bound is
 * therefore a few percent higher than one with a map (PoseBound), and higher still in round and
 * cluttered places, where a matcher can be better than it. */
struct PairBound
{
  /** The inverse of the bound of the covariance of the error (x, y, phi) of T_ref_cur in the axes
   * of the reference: m, m, rad. It is singular, or nearly so, in directions that the scans do not
   * constrain, and zero if they have no line in common. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/** Computes the bound of two scans.
 *  @param noise of the ranges, known and > 0 */
PairBound pairBound(const Scan& reference, const Scan& current, const Pose2& T_ref_cur_true,
                    const RangeNoise& noise);

/** Random errors of a matcher that reaches the bound of each pair: normally distributed with the
 * covariances of the bounds, several for each pair. The same bounds give the same errors. An error
 * is infinite if the scans do not constrain it. */
std::vector<PairError> drawnErrors(const std::vector<PairBound>& bounds);

/** Statistics of drawnErrors(); NaN without bounds. */
struct BoundSummary
{
  double translationMedian_m = 0, translationP95_m = 0;
  double rotationMedian_rad = 0, rotationP95_rad = 0;
};

BoundSummary summarize(const std::vector<PairBound>& bounds);
}  // namespace psmks
