/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>
#include <psmks/sim/Route.h>

namespace psmks
{
struct WaypointOptions
{
  double speed_mps = 0.6;
  double turnRate_radps = 1;  //!< at most; tight bends are driven so much slower
  double lookAhead_m = 0.5;   //!< the point of the route that the robot heads for
};

/** Follows a route by its true pose, as a person with a joystick would, and stops at its end: heads
 * for the point of the route a look-ahead away (pure pursuit), and turns on the spot where that
 * lies far aside. */
class WaypointDriver : public Driver
{
 public:
  /** @param route at least one point */
  WaypointDriver(const WaypointOptions& options, const RobotOptions& robot, Route route);

  WheelSpeeds drive(const DriverView& view) override;
  bool isDone() const override { return done_; }

 private:
  /** Along the route until it is a look-ahead away. */
  void moveTarget(const Eigen::Vector2d& robot_m);

  WaypointOptions options_;
  double track_m_;
  Route route_;
  Eigen::Vector2d target_m_;  //!< of the route: the robot heads for it
  std::size_t next_ = 0;      //!< the point of the route that the target moves to
  bool done_ = false;
};
}  // namespace psmks
