/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/OdometryTrack.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** A share of a motion: each coordinate, in the frame at its start. */
Pose2 shareOf(const Pose2& motion, double share)
{
  return {share * motion.x_m, share * motion.y_m, wrapAngle(share * motion.phi_rad)};
}
}  // namespace

void OdometryTrack::add(double stamp_s, const Pose2& T_odom_robot)
{
  if (last_ && stamp_s < last_->stamp_s)
    beforeLast_.reset();
  else if (last_ && stamp_s > last_->stamp_s)
    beforeLast_ = last_;
  last_ = Reading{stamp_s, T_odom_robot};
}

std::optional<Pose2> OdometryTrack::poseAt(double stamp_s) const
{
  if (!last_ || stamp_s - last_->stamp_s > kMaxAge_s) return std::nullopt;
  if (!beforeLast_) return last_->T_odom_robot;
  const double span_s = last_->stamp_s - beforeLast_->stamp_s;
  if (span_s > kMaxAge_s) return last_->T_odom_robot;

  const Pose2 step = beforeLast_->T_odom_robot.inverse() * last_->T_odom_robot;
  const double share = (stamp_s - last_->stamp_s) / span_s;
  if (share > 0) return last_->T_odom_robot * shareOf(step, share);
  return beforeLast_->T_odom_robot * shareOf(step, std::max(0.0, 1 + share));
}
}  // namespace psmks
