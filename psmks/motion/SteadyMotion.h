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
 * The speed is learnt from motions that scans measured, and its uncertainty grows with the time
 * since then. With this time t, counted to the end of a motion of duration T, the standard
 * deviation of the motion is OdometryOptions::minSigma_m + accelerationSigma_m_s2 t T, and at most
 * unknownSigma_m; that of its heading accordingly. A speed that is older than kLongest_s says
 * nothing: then the robot is taken to stand, with unknownSigma_m and unknownSigma_rad. */
class SteadyMotion
{
 public:
  /** Age of a speed from which on it says nothing of a motion. Unit: s. Evidence: measured. */
  static constexpr double kLongest_s = 1.0;

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
  double period_s() const;
  UncertainPose unknown(const Pose2& motion) const;

  OdometryOptions options_;
  std::optional<double> lastStamp_s_;
  std::deque<double> durations_s_;  //!< of the last motions
  int periods_ = 1;                 //!< of the last motion
  Pose2 T_per_period_;              //!< the motion that was learnt, in one period
  bool isLearnt_ = false;
  double age_s_ = 0;  //!< of the speed, at the last scan
};
}  // namespace psmks
