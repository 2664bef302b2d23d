/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/sim/Robot.h>

namespace psmks
{
/** What a driver knows at a control cycle. */
struct DriverView
{
  const Scan& scan;  //!< in the sensor's frame
  Pose2 T_robot_sensor;
  Pose2 T_start_odometry;  //!< by the wheels
  Pose2 T_world_robot;     //!< the truth: only for drivers that stand for a person
  WheelSpeeds speeds;      //!< of the wheels now
  bool bumped = false;     //!< the robot touched something since the last cycle
  double time_s = 0;       //!< since the start
};

/** Whoever steers the robot: called once a scan. */
class Driver
{
 public:
  virtual ~Driver() = default;

  virtual WheelSpeeds drive(const DriverView& view) = 0;

  /** True when the drive is over: the end of a route. */
  virtual bool isDone() const { return false; }
};
}  // namespace psmks
