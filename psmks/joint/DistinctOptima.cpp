/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/joint/DistinctOptima.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
bool isSameOptimum(const Pose2& a, const Pose2& b, const Eigen::Vector2d& openDirection)
{
  /** Distance and angle within which two refined poses are the same optimum. Evidence: measured. */
  constexpr double kElsewhere_m = 0.1, kTurned_rad = degToRad(2);
  Eigen::Vector2d apart_m = b.translation() - a.translation();
  apart_m -= openDirection.dot(apart_m) * openDirection;
  return apart_m.norm() <= kElsewhere_m && std::abs(wrapAngle(b.phi_rad - a.phi_rad)) < kTurned_rad;
}

void keepDistinctOptima(std::vector<RefinedPose>& poses, const Eigen::Vector2d& openDirection)
{
  std::sort(poses.begin(), poses.end(),
            [](const RefinedPose& a, const RefinedPose& b)
            { return a.logPosterior > b.logPosterior; });
  auto end = poses.begin();
  for (const RefinedPose& pose : poses)
  {
    const auto isSame = [&](const RefinedPose& kept)
    { return isSameOptimum(kept.T_ref_cur, pose.T_ref_cur, openDirection); };
    if (std::none_of(poses.begin(), end, isSame)) *end++ = pose;
  }
  poses.erase(end, poses.end());
}
}  // namespace psmks
