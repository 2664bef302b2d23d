/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Interpolation.h>
#include <psmks/geometry/Angle.h>

#include <algorithm>

namespace psmks
{
double Bracket::nearest_s(double stamp_s) const
{
  return std::min(stamp_s - before.stamp_s, after.stamp_s - stamp_s);
}

Pose2 Bracket::poseAt(double stamp_s) const
{
  const Pose2 &a = before.pose, &b = after.pose;
  const double share = gap_s() > 0 ? (stamp_s - before.stamp_s) / gap_s() : 0;
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m),
          wrapAngle(a.phi_rad + share * wrapAngle(b.phi_rad - a.phi_rad))};
}

std::optional<Bracket> bracketAt(const Trajectory& trajectory, double stamp_s)
{
  const auto after = std::lower_bound(trajectory.begin(), trajectory.end(), stamp_s,
                                      [](const StampedPose& p, double t) { return p.stamp_s < t; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->stamp_s == stamp_s) return Bracket{*after, *after};
  if (after == trajectory.begin()) return std::nullopt;
  const Bracket bracket{*std::prev(after), *after};
  if (bracket.gap_s() > kMaxGap_s) return std::nullopt;
  return bracket;
}

std::optional<Pose2> poseAt(const Trajectory& trajectory, double stamp_s)
{
  const auto bracket = bracketAt(trajectory, stamp_s);
  if (!bracket) return std::nullopt;
  return bracket->poseAt(stamp_s);
}
}  // namespace psmks
