/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/matchers/PairMatcher.h>
#include <psmks/motion/OdometryNoise.h>
#include <psmks/motion/OdometryQuality.h>
#include <psmks/motion/SequenceDeskewer.h>
#include <psmks/motion/SteadyMotion.h>
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/LoopSearch.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/PosedScanMatcher.h>
#include <psmks/slam/ReferencePolicy.h>

#include <memory>
#include <optional>
#include <vector>

namespace psmks
{
/** Builds the trajectory of a robot from its scans and odometry: every scan gets a pose.
 *
 *     world --T--> robot at the reference --T_ref_cur--> last robot --odometry--> robot
 *
 * Each scan passes these steps:
 *
 * 1. Predict: the motion since the scan before is that of the odometry, or without odometry the
 *    last motion that scans measured, going on (SteadyMotion). It deskews the scan
 *    (SequenceDeskewer).
 * 2. Choose the reference: with a map the nearest keyframe that saw enough of the scan, else the
 *    one that stands.
 * 3. Match against the reference, with the prediction and its covariance as a prior. Where that
 *    fails or explains little, the scan before serves as a second reference, unless it is the
 *    reference of other scans already or was not matched itself. Where no match is usable then, the
 *    last try is against the reference once more, the prior widened by the covariance of a motion
 *    that nobody measured. A scan in which nothing was seen fails once, and does not count as a
 *    failure of the reference.
 * 4. Place: the match places the scan, or where all failed the prediction.
 * 5. Replace the reference by the scan, if ReferencePolicy says so. A keyframe is matched against
 *    the keyframes around it, and the matches link it into a graph of poses (KeyframeMap). With a
 *    map places that the robot may have come back to are searched, too (LoopSearch).
 *
 * The scans are those of one scanner: what earlier ones have shown of its noise counts for later
 * ones, see PreparedScans. */
class TrajectoryBuilder
{
 public:
  /** @param matcher not null; any method, see makePairMatcher() */
  TrajectoryBuilder(std::unique_ptr<PairMatcher> matcher, const ReferenceOptions& reference,
                    const OdometryOptions& odometry);

  /** Gives a scan its pose.
   *  @param scan with its stamp, in the frame of a sensor that is mounted at T_robot_sensor
   *  @param odometry motion of the robot since the scan before, in the frame of the robot at that
   * scan; not looked at for the first scan
   *  @return the scan with its pose, as it stands until the next call. The pose of the first scan
   * is the identity. */
  const PosedScan& add(Scan scan, const Pose2& T_robot_sensor,
                       const std::optional<Pose2>& odometry);

  /** Moves the keyframes to where all links between them say together, and every other scan with
   * its reference. A loop that closes late moves what was driven before: call this after the last
   * scan. Changes nothing where no links were made, as with ReferenceChoice::Sequential. */
  void optimise();

  /** All scans so far, in the order they came. */
  const std::vector<PosedScan>& scans() const { return scans_; }

  /** The keyframes and the links between them; empty with ReferenceChoice::Sequential. */
  const KeyframeMap& map() const { return map_; }

 private:
  /** The last scan seen from a keyframe by a match and the motions since then. The poses of the map
   * have no part in it but as a prior of the match, so that it is evidence for them. */
  struct Evidence
  {
    std::size_t keyframe = 0;
    UncertainPose T_keyframe_last;
  };

  std::size_t currentIndex() const { return scans_.size() - 1; }
  PosedScan& current() { return scans_.back(); }
  const PosedScan& current() const { return scans_.back(); }
  const PosedScan& previous() const { return scans_[scans_.size() - 2]; }

  UncertainPose motionBy(const std::optional<Pose2>& odometry, double stamp_s);
  void learnMotion(const UncertainPose& predicted);
  void append(Scan scan, const Pose2& T_robot_sensor, const std::optional<Pose2>& odometry,
              const UncertainPose& motion);
  void chooseKeyframe();
  UncertainPose matched(const UncertainPose& motion, const UncertainPose& T_ref_predicted);
  void retryWithPrevious(const UncertainPose& motion);
  void retryWithWidePrior(const UncertainPose& motion);
  void place(const UncertainPose& T_ref_cur);
  void followPrediction();
  bool becomesReference();
  void makeReference(std::size_t index);
  void addToMap(std::size_t index);
  std::vector<ReferenceMatch> matchesAround(std::size_t index);

  ReferencePolicy policy_;
  OdometryOptions odometryOptions_;
  PosedScanMatcher matcher_;
  KeyframeMap map_{policy_};
  LoopSearch loopSearch_{policy_};
  SteadyMotion steadyMotion_;
  OdometryQuality odometryQuality_;
  bool isMotionMeasured_ = false;  //!< whether odometry tells the motion to the current scan
  SequenceDeskewer deskewer_;
  std::vector<PosedScan> scans_;
  std::size_t reference_ = 0;
  UncertainPose T_ref_last_;  //!< robot at the last scan, seen from the robot at the reference: by
                              //!< a match, by the motion since then, or by the poses of the map
  Evidence evidence_;         //!< about the last scan, for its link where it becomes a keyframe
  int failuresInARow_ = 0;    //!< of scans that saw something, since the reference
                              //!< was made one
};
}  // namespace psmks
