/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/sim/Robot.h>

namespace psmks
{
/** What a driver knows in a control cycle. */
struct DriverView
{
  const Scan& scan;  //!< in the sensor frame
  Pose2 T_robot_sensor;
  Pose2 T_start_odometry;  //!< pose by the odometry
  Pose2 T_world_robot;     //!< true pose, for drivers that stand for a person
  WheelSpeeds speeds;      //!< present speeds of the wheels
  bool bumped = false;     //!< whether the robot touched something since the last cycle
  double time_s = 0;       //!< time since the start
};

/** Steers a robot. It is asked for the speeds of the wheels once for each scan. */
class Driver
{
 public:
  virtual ~Driver() = default;

  virtual WheelSpeeds drive(const DriverView& view) = 0;

  /** Whether the drive is over, as at the end of a route. */
  virtual bool isDone() const { return false; }
};
}  // namespace psmks
