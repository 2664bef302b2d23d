/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/geometry/UncertainPose.h>
#include <psmks/match/MatchResult.h>

#include <vector>

namespace psmks
{
/** A match of a scan against the reference that stood then. */
struct ReferenceMatch
{
  std::size_t reference = 0;  //!< index of the reference's frame
  UncertainPose T_ref_cur;    //!< of the robots, where the result is that of the sensors
  MatchResult result;
  double time_s = 0;  //!< wall time of the match, segmentation of the scan included
};

/** A scan with its place on the trajectory. The world is the frame of the robot at the first scan.
 */
struct PosedScan
{
  Scan scan;
  Pose2 T_robot_sensor;
  UncertainPose T_world_robot;
  UncertainPose T_last_robot;           //!< motion since the scan before, in the robot's frame then
  Pose2 T_world_odometry;               //!< where the odometry alone puts the robot
  std::vector<ReferenceMatch> matches;  //!< in the order they were tried; the last one counts
  std::vector<ReferenceMatch> links;    //!< to other keyframes of a map, when it joined them
  bool isReference = false;             //!< now or at some time
  std::size_t anchor = 0;               //!< index of the scan its pose hangs on, or its own
  Pose2 T_anchor_robot;

  /** False where odometry alone, or nothing, says where the robot stands. */
  bool isMatched() const { return !matches.empty() && matches.back().result.usable(); }

  double stamp_s() const { return scan.stamp_s; }
  Pose2 T_world_sensor() const { return T_world_robot.pose * T_robot_sensor; }
};
}  // namespace psmks
