/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/PlanarVelocity.h>

namespace psmks
{
PlanarVelocity velocityOfSensor(const PlanarVelocity& ofRobot, const Pose2& T_robot_sensor)
{
  const Eigen::Vector2d swing_m_s =
      ofRobot.phi_rad_s * Eigen::Vector2d(-T_robot_sensor.y_m, T_robot_sensor.x_m);
  const Eigen::Vector2d inRobot_m_s = Eigen::Vector2d(ofRobot.x_m_s, ofRobot.y_m_s) + swing_m_s;
  const Eigen::Vector2d inSensor_m_s = T_robot_sensor.rotation().transpose() * inRobot_m_s;
  return {inSensor_m_s.x(), inSensor_m_s.y(), ofRobot.phi_rad_s};
}

void MeanVelocity::add(double stamp_s, const UncertainPose& T_before_now)
{
  const Pose2& motion = T_before_now.pose;
  if (!std::isfinite(stamp_s) || !motion.isFinite()) return readings_.clear();
  Reading reading{stamp_s, {0, 0}, 0, T_before_now.covariance};
  if (!readings_.empty())
  {
    const Reading& before = readings_.back();
    const Pose2 T_first_before{before.place_m.x(), before.place_m.y(), before.heading_rad};
    reading.place_m = T_first_before * motion.translation();
    reading.heading_rad = before.heading_rad + motion.phi_rad;
  }
  if (!readings_.empty() && stamp_s < readings_.back().stamp_s) readings_.clear();
  readings_.push_back(reading);
  while (readings_.size() > 2 && stamp_s - readings_[1].stamp_s >= kWindow_s) readings_.pop_front();
}

double MeanVelocity::window_s() const
{
  if (readings_.size() < 2) return 0;
  const double time_s = readings_.back().stamp_s - readings_.front().stamp_s;
  return time_s >= kWindow_s / 4 && time_s <= kMaxAge_s ? time_s : 0;
}

Eigen::Matrix3d MeanVelocity::covariance() const
{
  const double time_s = window_s();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  if (time_s == 0) return sum;
  for (std::size_t r = 1; r < readings_.size(); ++r) sum += readings_[r].covariance;
  return sum / (time_s * time_s);
}

PlanarVelocity MeanVelocity::velocity() const
{
  const double time_s = window_s();
  if (time_s == 0) return {};
  const Reading &first = readings_.front(), &last = readings_.back();
  // The chord of an arc points along the heading at its middle.
  const Pose2 middle{0, 0, (first.heading_rad + last.heading_rad) / 2};
  const Eigen::Vector2d moved_m = middle.rotation().transpose() * (last.place_m - first.place_m);
  return {moved_m.x() / time_s, moved_m.y() / time_s,
          (last.heading_rad - first.heading_rad) / time_s};
}
}  // namespace psmks
