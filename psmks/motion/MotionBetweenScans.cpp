/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/MotionBetweenScans.h>

#include <cmath>
#include <utility>

namespace psmks
{
void MotionBetweenScans::addReading(double stamp_s, const Pose2& T_odom_robot)
{
  if (std::isfinite(stamp_s) && T_odom_robot.isFinite()) track_.add(stamp_s, T_odom_robot);
}

void MotionBetweenScans::addIncrement(const Pose2& T_before_after)
{
  hasIncrements_ = true;
  T_lastScan_robot_ = T_lastScan_robot_.value_or(Pose2()) * T_before_after;
}

std::optional<Pose2> MotionBetweenScans::untilScan(double stamp_s)
{
  if (hasIncrements_)
  {
    const auto motion = std::exchange(T_lastScan_robot_, std::nullopt);
    return motion && motion->isFinite() ? motion : std::nullopt;
  }
  const auto T_odom_before = std::exchange(T_odom_lastScan_, track_.poseAt(stamp_s));
  if (!T_odom_before || !T_odom_lastScan_) return std::nullopt;
  return T_odom_before->inverse() * *T_odom_lastScan_;
}
}  // namespace psmks
