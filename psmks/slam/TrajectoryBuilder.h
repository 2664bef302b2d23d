/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/matchers/PairMatcher.h>
#include <psmks/motion/OdometryNoise.h>
#include <psmks/motion/Sweep.h>
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

#include <memory>
#include <optional>
#include <vector>

namespace psmks
{
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

  /** Moves every scan to where the reference it hangs on has come to be since: with a map, loops
   *  that closed later move what was driven before. */
  void optimise();

  /** All scans so far, in the order they came. */
  const std::vector<PosedScan>& scans() const { return scans_; }

 private:
  void place(PosedScan& current, const std::optional<Pose2>& odometry);
  void straighten(PosedScan& current, const std::optional<Pose2>& odometry);
  UncertainPose matched(PosedScan& current, const UncertainPose& motion,
                        const UncertainPose& guess);
  void retry(PosedScan& current, const UncertainPose& motion);
  void matchToLast(PosedScan& current, const UncertainPose& motion);
  void matchWithInflatedPrior(PosedScan& current, const UncertainPose& motion);
  UncertainPose measuredMotion(const std::optional<Pose2>& odometry) const;
  ReferenceMatch match(const PosedScan& current, std::size_t reference,
                       const UncertainPose& T_ref_cur, SearchScope scope = SearchScope::Full);
  bool isNewReference() const;
  void makeReference(std::size_t index);
  void returnTo(std::size_t keyframe);
  void joinMap(std::size_t index);
  std::vector<ReferenceMatch> matchesAround(const PosedScan& current);
  std::vector<ReferenceMatch> consistentLinks(const PosedScan& current,
                                              const std::vector<ReferenceMatch>& found) const;

  std::unique_ptr<PairMatcher> matcher_;
  ReferencePolicy policy_;
  KeyframeMap map_{policy_};
  OdometryOptions odometryOptions_;
  TurnRate turnRate_;
  std::vector<PosedScan> scans_;
  std::size_t reference_ = 0;
  UncertainPose T_ref_last_;  //!< robot at the last scan, seen from the reference's
  int failuresInARow_ = 0;
};
}  // namespace psmks
