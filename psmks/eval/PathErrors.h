/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/PairError.h>

#include <vector>

namespace psmks
{
/** What lays the world of the estimate over that of the truth: T_true = T_truth_estimate *
 * T_estimated at the first common pose, as the paper does. Identity without poses. */
Pose2 layFirstPoseOver(const std::vector<CommonPose>& common);

/** The same, with the least sum of squared distances between the positions (Umeyama, IEEE PAMI 13
 * (1991), in the plane and without scale). Where the positions leave the rotation open, as those of
 * a robot at rest do, the headings decide. */
Pose2 align(const std::vector<CommonPose>& common);

/** Errors of the poses, one for each: T_true^-1 T_truth_estimate T_estimated. */
std::vector<PairError> absoluteErrors(const std::vector<CommonPose>& common,
                                      const Pose2& T_truth_estimate);

/** Errors of the motions between consecutive poses at which the truth was measured. */
std::vector<PairError> stepErrors(const std::vector<CommonPose>& common);

/** Errors of the motions over a length of the true path: from every pose to the first that comes at
 * least so much further along the path, scaled to exactly that length. None where the path is
 * shorter.
 *  @param length_m > 0 */
std::vector<PairError> driftErrors(const std::vector<CommonPose>& common, double length_m);

/** Length of the true path up to each pose, straight from pose to pose. */
std::vector<double> truePathLengths_m(const std::vector<CommonPose>& common);
}  // namespace psmks
