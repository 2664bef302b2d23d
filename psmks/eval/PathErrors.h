/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/PairError.h>

#include <vector>

namespace psmks
{
/** The transformation T_truth_estimate that makes estimate and truth coincide at the first common
 * pose, as in the paper. Where a heading of that pose is not known, only its positions coincide,
 * and the rotation is that of align(). It is the identity without poses. */
Pose2 alignAtFirstPose(const std::vector<CommonPose>& common);

/** The transformation T_truth_estimate with the least sum of squared distances between the
 * positions (Umeyama, IEEE PAMI 13 (1991), in the plane and without scale). If the positions do not
 * determine the rotation, as for a robot at rest, the headings do. */
Pose2 align(const std::vector<CommonPose>& common);

/** The errors of the poses, T_true^-1 T_truth_estimate T_estimated, one for each. The rotation is
 * NaN where a heading is not known. */
std::vector<PairError> absoluteErrors(const std::vector<CommonPose>& common,
                                      const Pose2& T_truth_estimate);

/** The errors of the motions between consecutive poses at which the truth was measured with its
 * heading. */
std::vector<PairError> stepErrors(const std::vector<CommonPose>& common);

/** The errors of the motions over a length of the true path: from each pose to the first one that
 * is at least this length further along the path, scaled to exactly this length. There are none if
 * the path is shorter, and none between poses without a heading.
 *  @param length_m > 0 */
std::vector<PairError> driftErrors(const std::vector<CommonPose>& common, double length_m);

/** The length of the true path up to each pose, measured straight from pose to pose. */
std::vector<double> truePathLengths_m(const std::vector<CommonPose>& common);
}  // namespace psmks
