/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/Interpolation.h>
#include <psmks/eval/Jumps.h>
#include <psmks/eval/StampIndex.h>

namespace psmks
{
namespace
{
bool contradict(const Pose2& a, const Pose2& b) { return !isSuccess(pairError(a, b), kJumpLimit); }
}  // namespace

int countJumps(const Trajectory& estimate, const Trajectory& odometry,
               const std::vector<Relation>& truth)
{
  const StampIndex index(estimate);
  int jumps = 0;
  for (const auto& [from_s, to_s, T_from_to] : truth)
  {
    const auto from = index.nearest(from_s, kStampTolerance_s);
    const auto to = index.nearest(to_s, kStampTolerance_s);
    if (!from || !to) continue;
    const auto motion = [from = *from, to = *to](const Trajectory& trajectory)
    { return trajectory[from].pose.inverse() * trajectory[to].pose; };
    const Pose2 estimated = motion(estimate);
    if (contradict(estimated, T_from_to) && contradict(estimated, motion(odometry))) ++jumps;
  }
  return jumps;
}

std::vector<Relation> trueSteps(const Trajectory& estimate, const Trajectory& truth)
{
  std::vector<Relation> steps;
  const CommonPose* last = nullptr;
  const std::vector<CommonPose> common = commonPoses(estimate, truth);
  for (const CommonPose& pose : common)
  {
    if (!pose.isMeasured) continue;
    if (last) steps.push_back({last->stamp_s, pose.stamp_s, last->T_true.inverse() * pose.T_true});
    last = &pose;
  }
  return steps;
}
}  // namespace psmks
