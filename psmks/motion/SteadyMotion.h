/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>
#include <psmks/motion/OdometryNoise.h>

#include <deque>
#include <optional>

namespace psmks
{
/** Predicts the motion of a robot without odometry from one scan to the next: it goes on as it did
 * last, while unknown accelerations change its speed.
 *
 *     scans        x---x---x-------x       x: a period is the usual time between two scans
 *     motion         1   1     2           in periods: stamps jitter more than scanners turn
 *
 * The speed is learnt from the motion to the scan before, if scans measured it. The standard
 * deviation of a motion of duration T is then OdometryOptions::minSigma_m + accelerationSigma_m_s2
 * T^2, and at most unknownSigma_m; that of its heading accordingly. Else, and where three
 * scans are missing or more, nothing is known: the robot is taken to stand, with unknownSigma_m and
 * unknownSigma_rad. A robot whose scanner has gone blind may have been stopped for it. */
class SteadyMotion
{
 public:
  explicit SteadyMotion(const OdometryOptions& options) : options_(options) {}

  /** The motion until a scan, in the frame of the robot at the scan before. To be called once for
   *  every scan, in the order of time.
   *  @param stamp_s the time of the scan. Where it is not finite, or not after the one before, the
   *  motion before is repeated, with unknownSigma_m and unknownSigma_rad. */
  UncertainPose untilScan(double stamp_s);

  /** Takes what the scans say of the motion to the last scan for the speed from now on. */
  void learn(const Pose2& T_before_last);

 private:
  std::optional<double> sinceLastScan_s(double stamp_s);
  double usualPeriod_s() const;
  UncertainPose unknown(const Pose2& motion) const;

  OdometryOptions options_;
  std::optional<double> lastStamp_s_;
  std::deque<double> durations_s_;  //!< of the last motions
  int periods_ = 1;                 //!< of the last motion
  Pose2 T_per_period_;              //!< the motion that was learnt, in one period
  bool isGap_ = false;              //!< whether the last motion lasted too long to tell a speed
  bool isKnown_ = false;            //!< whether it was learnt at the last scan
};
}  // namespace psmks
