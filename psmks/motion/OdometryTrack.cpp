/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/OdometryTrack.h>

#include <algorithm>

namespace psmks
{
void OdometryTrack::add(double stamp_s, const Pose2& T_odom_robot)
{
  // Two readings with the same stamp would give an infinite speed.
  if (last_ && stamp_s > last_->stamp_s) beforeLast_ = last_;
  last_ = Reading{stamp_s, T_odom_robot};
}

std::optional<Pose2> OdometryTrack::poseAt(double stamp_s) const
{
  if (!last_ || stamp_s - last_->stamp_s > kMaxAge_s) return std::nullopt;
  if (!beforeLast_) return last_->T_odom_robot;
  const double span_s = last_->stamp_s - beforeLast_->stamp_s;
  if (span_s <= 0 || span_s > kMaxAge_s) return last_->T_odom_robot;

  const double share = std::max(-1.0, (stamp_s - last_->stamp_s) / span_s);
  const Pose2 step = beforeLast_->T_odom_robot.inverse() * last_->T_odom_robot;
  return last_->T_odom_robot *
         Pose2{share * step.x_m, share * step.y_m, wrapAngle(share * step.phi_rad)};
}
}  // namespace psmks
