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
/** How well the relative pose of two scans can be known: the Cramer-Rao bound with the lines and
 * circles of the world as unknowns, both scans noisy, linearised at the true pose.
 *
 * It needs no map of the world, so that it can be had for measured scans too: the lines are those
 * that the scans themselves show once they lie on each other. What neither scan shows as a line of
 * 3 rays or more or both do not show as a circle is left out, and so are ends and corners: the
 * bound is a few percent higher than with a map (PoseBound), and in round and cluttered places
 * more, where a matcher may even be better than it. */
struct PairBound
{
  /** Inverse of the bound of the error (x, y, phi) of T_ref_cur in the axes of the reference: m, m,
   * rad. Singular or nearly so where the scans leave it open; zero where they have no line in
   * common. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/** @param noise of the ranges, known and > 0 */
PairBound pairBound(const Scan& reference, const Scan& current, const Pose2& T_ref_cur_true,
                    const RangeNoise& noise);

/** Errors of a matcher that reaches the bound of every pair: normal ones drawn with the covariance
 * of each bound, several a pair, the same for the same bounds. Infinite where a pair leaves them
 * open. */
std::vector<PairError> drawnErrors(const std::vector<PairBound>& bounds);

/** The figures of drawnErrors(); NaN without bounds. */
struct BoundSummary
{
  double translationMedian_m = 0, translationP95_m = 0;
  double rotationMedian_rad = 0, rotationP95_rad = 0;
};

BoundSummary summarize(const std::vector<PairBound>& bounds);
}  // namespace psmks
