/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/motion/OdometryTrack.h>

#include <optional>

namespace psmks
{
/** The motion of a robot from one scan to the next, from what its odometry reports in between.
 *
 * Odometry comes either as absolute readings at times of their own or as increments; from the first
 * increment on, readings are ignored.
 *
 *     readings     r----r----r----r        increments   |-->|-->|     |-->|
 *     scans           s         s          scans        s       s     s   s
 *                     '-motion--'                       'motion-'none-'---' */
class MotionBetweenScans
{
 public:
  /** The robot's pose in the frame of its odometry at a time, see OdometryTrack. Readings come in
   *  the order of time. A reading that is not finite is ignored. */
  void addReading(double stamp_s, const Pose2& T_odom_robot);

  /** The motion since the increment before, or since the last scan, in the robot's frame then. An
   *  increment that is not finite leaves the motion until the next scan unknown. */
  void addIncrement(const Pose2& T_before_after);

  /** The motion of the robot since the scan before, in the robot's frame at that scan. To be called
   *  once for every scan, in the order of time.
   *  @param stamp_s the time of the scan, which only readings need
   *  @return none where no increment came since the scan before, or where there is no reading near
   *  the time of one of both scans, see OdometryTrack::poseAt() */
  std::optional<Pose2> untilScan(double stamp_s);

 private:
  OdometryTrack track_;
  std::optional<Pose2> T_odom_lastScan_;
  bool hasIncrements_ = false;
  std::optional<Pose2> T_lastScan_robot_;  //!< the increments since the last scan
};
}  // namespace psmks
