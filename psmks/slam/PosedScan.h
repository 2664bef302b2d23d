/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/geometry/UncertainPose.h>
#include <psmks/match/MatchResult.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace psmks
{
/** A match of one scan of a trajectory against another one. */
struct ReferenceMatch
{
  std::size_t reference = 0;  //!< index of the reference scan in the trajectory
  UncertainPose T_ref_cur;    //!< pose of the robot at the current scan, seen from the robot at the
                              //!< reference scan
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  //!< what the scans alone say of that pose
  MatchResult result;  //!< of the two sensors, as the matcher gave it
  double time_s = 0;   //!< wall time of the match, with the preparation of those of the two scans
                       //!< that no earlier match had prepared
};

/** A scan with its place on the trajectory. The frames of its poses:
 *
 * - world: the robot at the first scan;
 * - robot, sensor: the robot and its scanner at this scan;
 * - last: the robot at the scan before;
 * - anchor: the robot at the scan that this one moves with;
 * - odometry: the robot at this scan, where the odometry alone puts it.
 *
 * The covariance of T_world_robot is that of the matches and motions by which the scan was placed,
 * one after the other from the first scan on, their errors taken as independent. A loop that closes
 * later moves the pose and leaves the covariance as it was. */
struct PosedScan
{
  Scan scan;
  Pose2 T_robot_sensor;
  UncertainPose T_world_robot;
  UncertainPose T_last_robot;  //!< motion since the scan before
  Pose2 T_world_odometry;      //!< the motions that the odometry measured, one after the other
  std::vector<ReferenceMatch> matches;  //!< all that were tried to place the scan, in that order
  std::size_t deciding = 0;             //!< index into `matches` of the one that places the scan
  std::vector<ReferenceMatch> links;    //!< matches against other keyframes, made when this scan
                                        //!< became a keyframe itself
  bool isReference = false;             //!< whether it is, or was, the reference of later scans
  std::size_t anchor = 0;  //!< index of the reference scan that this one moves with; its own where
                           //!< there is none
  Pose2 T_anchor_robot;    //!< stays as it is when the anchor moves

  /** Adds the match that places the scan from now on. */
  void decideBy(ReferenceMatch match)
  {
    matches.push_back(std::move(match));
    deciding = matches.size() - 1;
  }

  /** The match that places the scan, or null where none was tried. Where no match succeeded it is
   * the last one that was tried, whose pose is its guess. */
  const ReferenceMatch* decidingMatch() const
  {
    return matches.empty() ? nullptr : &matches[deciding];
  }

  /** Whether a match says where the robot stands. Else odometry does, or for the first scan
   * nothing. */
  bool isMatched() const { return !matches.empty() && matches[deciding].result.usable(); }

  double stamp_s() const { return scan.stamp_s; }
  Pose2 T_world_sensor() const { return T_world_robot.pose * T_robot_sensor; }
};

/** Whether the odometry of a log moved at some time; a log without odometry has none that did. */
inline bool hasOdometry(const std::vector<PosedScan>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const PosedScan& scan) {
                       return !scan.T_world_odometry.translation().isZero() ||
                              scan.T_world_odometry.phi_rad != 0;
                     });
}
}  // namespace psmks
