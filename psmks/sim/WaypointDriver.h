/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>
#include <psmks/sim/Route.h>

namespace psmks
{
struct WaypointOptions
{
  double speed_mps = 0.6;
  double lookAhead_m = 0.5;  //!< the point of the route that the robot heads for
};

/** Follows a route by its true pose, as a person with a joystick would, and stops at its end. */
class WaypointDriver : public Driver
{
 public:
  WaypointDriver(const WaypointOptions& options, const RobotOptions& robot, Route route);

  WheelSpeeds drive(const DriverView& view) override;
  bool isDone() const override;
};
}  // namespace psmks
