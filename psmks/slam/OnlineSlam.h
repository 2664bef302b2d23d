/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/Scan.h>
#include <psmks/geometry/UncertainPose.h>
#include <psmks/match/MatchResult.h>
#include <psmks/motion/OdometryNoise.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

#include <functional>
#include <memory>
#include <vector>

namespace psmks
{
/** Everything that OnlineSlam can be told. The defaults build a map of keyframes and close loops;
 * `reference.choice` says what a scan is matched against. */
struct OnlineSlamOptions
{
  MatcherOptions matcher;
  ReferenceOptions reference;
  OdometryOptions odometry;
};

/** What the pose of a scan rests on. */
enum class PoseSource
{
  FirstScan,        //!< the first scan: its robot is the origin of the world, known exactly
  Match,            //!< a match against an earlier scan that is usable, see MatchStatus
  Odometry,         //!< the motion that the odometry measured, for no match is usable
  ConstantVelocity  //!< the motion before, once more: no match is usable and no odometry came
};

/** "FirstScan", "Match", ... */
const char* toString(PoseSource source);

/** What is known of the robot right after a scan. */
struct OnlinePose
{
  double stamp_s = 0;  //!< time of the scan

  /** The robot in the world, which is the frame of the robot at the first scan. The covariance
   *  holds the noise of the ranges and of the odometry, to first order, along the way from the
   *  first scan. On real walls, which are not exactly straight, errors are larger: the covariance
   * of a single match is too small by a factor of 15 for a low-cost scanner
   * (docs/when-it-fails.md). */
  UncertainPose T_world_robot;

  PoseSource source = PoseSource::FirstScan;

  /** The match that counts, in the frames of the two sensors; its status is NotRun where the scan
   *  was not matched, as the first one. */
  MatchResult match;
};

/** Localisation and mapping in a robot's loop: takes odometry and scans one by one, as they come,
 *  and tells after each scan where the robot is.
 *
 *     psmks::OnlineSlam slam;
 *     while (robot.runs())
 *     {
 *       slam.addOdometry(robot.time_s(), robot.wheelPose());
 *       const psmks::OnlinePose pose = slam.addScan(robot.scan());
 *     }
 *
 * It keeps every scan, some 10 kB each, so that the map can be drawn from scans() in the end. One
 * object serves one thread. Scans and odometry never throw, whatever they hold: a scan without a
 * return, or one that matches nothing, gets its pose from the odometry, and odometry that is
 * missing or not finite is replaced by the motion before. psmks/mrpt/ObservationSlam.h takes MRPT's
 * observations instead. */
class OnlineSlam
{
 public:
  /** @throws OptionError for options that the matcher does not accept */
  explicit OnlineSlam(const OnlineSlamOptions& options = {});
  ~OnlineSlam();
  OnlineSlam(OnlineSlam&&) noexcept;
  OnlineSlam& operator=(OnlineSlam&&) noexcept;

  /** A reading of the odometry: the robot's pose in the frame of the odometry at a time, on the
   *  clock of the scans' stamps, in the order of time. The motion between two scans is interpolated
   *  between readings, so a reading need not have the time of a scan. */
  void addOdometry(double stamp_s, const Pose2& T_odom_robot);

  /** The same for odometry that reports increments: the motion since the increment before, or since
   *  the last scan, in the robot's frame then. Readings that come beside increments are ignored. */
  void addMotion(const Pose2& T_before_after);

  /** A scan, with all odometry up to its time given before.
   *  @param scan with its stamp, in the order of time
   *  @param T_robot_sensor where the scanner sits on the robot
   *  @return the pose of the robot at this scan; the same goes to the listener */
  OnlinePose addScan(Scan scan, const Pose2& T_robot_sensor = {});

  using Listener = std::function<void(const OnlinePose&)>;

  /** Calls the listener within every addScan() from now on, in the caller's thread. An empty one
   *  ends that. */
  void setListener(Listener listener);

  /** Moves earlier scans to where loops that were closed later put them. Call it before scans() is
   *  drawn or saved; scans may be added afterwards. */
  void optimise();

  /** All scans so far with their poses and matches, in the order they came. */
  const std::vector<PosedScan>& scans() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};
}  // namespace psmks
