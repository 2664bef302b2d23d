/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/RefinedPose.h>

#include <vector>

namespace psmks
{
/** Whether two refined poses are the same optimum: nearer to each other than 0.1 m and 2 degrees,
 * within which refinements of one optimum end.
 *  @param openDirection unit vector along which distance does not count, for the scans do not fix
 *  the position along it; zero where they do */
bool isSameOptimum(const Pose2& a, const Pose2& b, const Eigen::Vector2d& openDirection);

/** Of refined poses, several of which may have ended at the same optimum, keeps one for each
 * optimum, the likeliest one; ordered by falling RefinedPose::logPosterior. */
void keepDistinctOptima(std::vector<RefinedPose>& poses, const Eigen::Vector2d& openDirection);
}  // namespace psmks
