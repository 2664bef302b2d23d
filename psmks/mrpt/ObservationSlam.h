/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose2D.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <psmks/slam/OnlineSlam.h>

#include <utility>
#include <vector>

namespace psmks
{
/** Everything that ObservationSlam can be told. Of `matching`, the section `view` is not used. */
struct ObservationSlamOptions
{
  ScanMatcherOptions matching;
  ReferenceOptions reference;
  OdometryOptions odometry;
};

/** OnlineSlam for a robot that speaks MRPT: takes its observations of odometry and scans one by
 *  one, as they come, and tells after each scan where the robot is.
 *
 * Everything that OnlineSlam promises holds here. A scan brings the pose of its sensor on the
 * robot, its scanning direction and its time. Scans of several sensors may be mixed; their noise is
 * then judged as if one scanner had taken them all. The result's pose as MRPT's Gaussian is
 * `toMrpt(pose.T_world_robot)`. */
class ObservationSlam
{
 public:
  /** @throws OptionError for options that the matcher does not accept */
  explicit ObservationSlam(const ObservationSlamOptions& options = {});

  /** A reading of the odometry. One without a time stamp counts as of the time of the last scan. */
  void addOdometry(const mrpt::obs::CObservationOdometry& odometry);

  /** The motion that the odometry measured since the increment before, or since the last scan, in
   *  the robot's frame then. */
  void addMotion(const mrpt::poses::CPose2D& T_before_after);

  /** A scan, with all odometry up to its time given before. A scan that is tilted by more than
   *  `matching.maxTilt_rad` is taken as one without a return.
   *  @return the pose of the robot at this scan; the same goes to the listener */
  OnlinePose addScan(const mrpt::obs::CObservation2DRangeScan& scan);

  /** As OnlineSlam::setListener(). */
  void setListener(OnlineSlam::Listener listener) { slam_.setListener(std::move(listener)); }

  /** As OnlineSlam::optimise(). */
  void optimise() { slam_.optimise(); }

  /** As OnlineSlam::scans(). */
  const std::vector<PosedScan>& scans() const { return slam_.scans(); }

 private:
  ScanMatcherOptions matching_;
  ScanConverter converter_;
  OnlineSlam slam_;
  double lastScan_s_ = 0;
};
}  // namespace psmks
