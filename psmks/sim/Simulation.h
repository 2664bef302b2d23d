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
  LaserOptions laser;         //!< must not take longer for a scan than the scan period
  Pose2 T_robot_sensor;       //!< mounting of the scanner; default: at the centre of the robot
  double scanPeriod_s = 0.1;  //!< a multiple of the noise step of the robot
  double duration_s = 600;
  double startStamp_s = 1e9;  //!< time of the first scan since the epoch
  unsigned seed = 1;          //!< of the noise of wheels and laser
};

/** A scan of a simulated drive with the true pose of the robot. */
struct RecordedScan
{
  SimulatedScan simulated;  //!< the scan, with its stamp
  Pose2 T_world_robot;      //!< true pose at the first ray
  Pose2 T_start_odometry;   //!< odometry at the first ray
  bool bumped = false;      //!< whether the robot touched something since the scan before
};

/** A simulated drive. */
struct Recording
{
  Pose2 T_robot_sensor;
  std::vector<RecordedScan> scans;

  double distance_m() const;           //!< true length of the path
  double turns() const;                //!< sum of all true rotations, in turns of 360 degrees
  int collisions() const;              //!< contacts in consecutive scans count once
  double longestStandstill_s() const;  //!< within 20 cm of one place
};

/** Drives a robot through its surroundings until the time is over or the driver is done. The driver
 * is asked once for each scan, at the end of its sweep. A step that would bring the robot closer to
 * an object than its radius is not made, and the robot stops.
 *  @param progress called after each scan with the share of the time that is over, 0 to 1 */
Recording simulate(const Surroundings& surroundings, const Pose2& T_world_start, Driver& driver,
                   const SimulationOptions& options,
                   const std::function<void(double)>& progress = nullptr);
}  // namespace psmks
