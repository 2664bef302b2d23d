/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/WaypointDriver.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kArrived_m = 0.1;
constexpr double kAlongRoute_m = 0.05;  // spacing at which the target moves along the route
/** Larger bearings of the target are turned to on the spot. */
constexpr double kTurnOnTheSpot_rad = degToRad(60);
constexpr double kReaction_s = 0.5;  // time in which a bearing is turned to

WheelSpeeds wheelSpeeds(double forward_mps, double rate_radps, double track_m)
{
  const double rim_mps = rate_radps * track_m / 2;
  return {forward_mps - rim_mps, forward_mps + rim_mps};
}
}  // namespace

WaypointDriver::WaypointDriver(const WaypointOptions& options, const RobotOptions& robot,
                               Route route)
    : options_(options),
      track_m_(robot.track_m),
      route_(std::move(route)),
      target_m_(route_.front())
{
}

void WaypointDriver::moveTarget(const Eigen::Vector2d& robot_m)
{
  while ((target_m_ - robot_m).norm() < options_.lookAhead_m && next_ < route_.size())
  {
    const Eigen::Vector2d toNext_m = route_[next_] - target_m_;
    if (toNext_m.norm() > kAlongRoute_m)
      target_m_ += kAlongRoute_m * toNext_m.normalized();
    else
      target_m_ = route_[next_++];
  }
}

WheelSpeeds WaypointDriver::drive(const DriverView& view)
{
  const Eigen::Vector2d robot_m = view.T_world_robot.translation();
  moveTarget(robot_m);
  const double distance_m = (target_m_ - robot_m).norm();
  done_ = done_ || (next_ == route_.size() && distance_m < kArrived_m);
  if (done_) return {};

  const Eigen::Vector2d target_m = view.T_world_robot.inverse() * target_m_;
  const double bearing_rad = std::atan2(target_m.y(), target_m.x());
  if (std::abs(bearing_rad) > kTurnOnTheSpot_rad)
  {
    const double rate_radps =
        std::clamp(bearing_rad / kReaction_s, -options_.turnRate_radps, options_.turnRate_radps);
    return wheelSpeeds(0, rate_radps, track_m_);
  }
  // Curvature of the arc that begins along the heading and passes through the target.
  const double curvature_1pm = 2 * std::sin(bearing_rad) / distance_m;
  const double forward_mps =
      std::min({options_.speed_mps, options_.turnRate_radps / std::abs(curvature_1pm),
                distance_m / kReaction_s});
  return wheelSpeeds(forward_mps, forward_mps * curvature_1pm, track_m_);
}
}  // namespace psmks
