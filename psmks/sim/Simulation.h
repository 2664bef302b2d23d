/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/Surroundings.h>

#include <functional>
#include <vector>

namespace psmks
{
struct SimulationOptions
{
  RobotOptions robot;
  LaserOptions laser;         //!< its sweep takes at most a scan period
  Pose2 T_robot_sensor;       //!< default: the scanner at the centre of the robot
  double scanPeriod_s = 0.1;  //!< a multiple of the robot's noise step
  double duration_s = 600;
  double startStamp_s = 1e9;  //!< of the first scan, since the epoch
  unsigned seed = 1;          //!< of the wheels and of the laser, each with its own engine
};

/** A scan of a simulated drive, with the truth. */
struct RecordedScan
{
  SimulatedScan simulated;  //!< with its stamp
  Pose2 T_world_robot;      //!< true, at the first ray
  Pose2 T_start_odometry;   //!< by the wheels, since the start, at the first ray
  bool bumped = false;      //!< the robot touched something since the scan before
};

/** A simulated drive. */
struct Recording
{
  Pose2 T_robot_sensor;
  std::vector<RecordedScan> scans;

  double distance_m() const;           //!< driven in truth
  double turns() const;                //!< sum of all rotation in truth, in turns of 360 degrees
  int collisions() const;              //!< one that lasts counts once
  double longestStandstill_s() const;  //!< within 20 cm of one place, turning or not
};

/** Drives a robot through its surroundings until the time is up or the driver is done: steers once
 * a scan, as soon as its sweep is over. A step that leads closer to something than the robot's
 * radius is not taken, and the robot stops.
 *  @param progress called after each scan with the share of the time that is over, 0 to 1 */
Recording simulate(const Surroundings& surroundings, const Pose2& T_world_start, Driver& driver,
                   const SimulationOptions& options,
                   const std::function<void(double)>& progress = nullptr);
}  // namespace psmks
