/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>
#include <psmks/sim/Route.h>

namespace psmks
{
struct WaypointOptions
{
  double speed_mps = 0.6;
  double turnRate_radps = 1;  //!< highest turn rate; the speed is reduced in tight bends
  double lookAhead_m = 0.5;   //!< distance of the point of the route that the robot heads for
};

/** Follows a route by the true pose, as a person with a joystick would, and stops at its end. The
 * robot heads for the point of the route at the look-ahead distance (pure pursuit) and turns on the
 * spot if the bearing of this point is large. */
class WaypointDriver : public Driver
{
 public:
  /** @param route with at least one point */
  WaypointDriver(const WaypointOptions& options, const RobotOptions& robot, Route route);

  WheelSpeeds drive(const DriverView& view) override;
  bool isDone() const override { return done_; }

 private:
  /** Moves the target along the route until it is at the look-ahead distance. */
  void moveTarget(const Eigen::Vector2d& robot_m);

  WaypointOptions options_;
  double track_m_;
  Route route_;
  Eigen::Vector2d target_m_;  //!< point of the route that the robot heads for
  std::size_t next_ = 0;      //!< index of the next point of the route after the target
  bool done_ = false;
};
}  // namespace psmks
