/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/OdometryNoise.h>
#include <psmks/core/ReferencePolicy.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/PairMatcher.h>

#include <memory>
#include <optional>
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
  bool isReference = false;             //!< now or at some time

  /** False where odometry alone, or nothing, says where the robot stands. */
  bool isMatched() const { return !matches.empty() && matches.back().result.usable(); }

  double stamp_s() const { return scan.stamp_s; }
  Pose2 T_world_sensor() const { return T_world_robot.pose * T_robot_sensor; }
};

/** Builds the trajectory of a robot from its scans and odometry: every scan gets a pose.
 *
 * A scan is matched against the reference that ReferencePolicy keeps, from the last known pose
 * moved on by the odometry, with the covariance of both as a prior. Where the match fails, that
 * pose is what the scan gets. Where a scan comes without odometry, the last motion is assumed once
 * more. With a map, the reference is chosen anew for every scan among all that were references.
 *
 *     world --T--> reference robot --T_ref_cur--> last robot --odometry--> robot */
class TrajectoryBuilder
{
 public:
  TrajectoryBuilder(std::unique_ptr<PairMatcher> matcher, const ReferenceOptions& reference,
                    const OdometryOptions& odometry);

  /** @param scan with its stamp, in the frame of a sensor that sits at T_robot_sensor
   *  @param odometry motion of the robot since the scan before, in the robot's frame at that scan
   */
  const PosedScan& add(Scan scan, const Pose2& T_robot_sensor,
                       const std::optional<Pose2>& odometry);

  /** All scans so far, in the order they came. */
  const std::vector<PosedScan>& scans() const { return scans_; }

 private:
  std::optional<std::size_t> bestKeyframe(const PosedScan& current) const;
  bool isCovered(const PosedScan& current) const;
  bool isSeenBy(std::size_t keyframe, const PosedScan& current) const;
  double doubt_m2(std::size_t keyframe, const PosedScan& current) const;
  void place(PosedScan& current, const std::optional<Pose2>& odometry);
  bool tryMatch(PosedScan& current, UncertainPose& T_ref_cur);
  UncertainPose measuredMotion(const std::optional<Pose2>& odometry) const;
  ReferenceMatch match(const PosedScan& current, const UncertainPose& guess);
  bool isNewReference() const;
  void makeReference(std::size_t index);
  void returnTo(std::size_t keyframe);

  std::unique_ptr<PairMatcher> matcher_;
  ReferencePolicy policy_;
  OdometryOptions odometryOptions_;
  std::vector<PosedScan> scans_;
  std::vector<std::size_t> keyframes_;  //!< the scans that are or were references
  std::size_t reference_ = 0;
  UncertainPose T_ref_last_;  //!< robot at the last scan, seen from the reference's
  int failuresInARow_ = 0;
};
}  // namespace psmks
