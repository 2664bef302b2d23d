/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <mrpt/system/datetime.h>
#include <psmks/mrpt/MountedScan.h>
#include <psmks/mrpt/ObservationSlam.h>

namespace psmks
{
ObservationSlam::ObservationSlam(const ObservationSlamOptions& options)
    : matching_(options.matching),
      slam_({options.matching.matcher, options.reference, options.odometry})
{
}

void ObservationSlam::addOdometry(const mrpt::obs::CObservationOdometry& odometry)
{
  const bool hasStamp = odometry.timestamp != INVALID_TIMESTAMP;
  slam_.addOdometry(hasStamp ? mrpt::Clock::toDouble(odometry.timestamp) : lastScan_s_,
                    toPose2(odometry.odometry));
}

void ObservationSlam::addMotion(const mrpt::poses::CPose2D& T_before_after)
{
  slam_.addMotion(toPose2(T_before_after));
}

OnlinePose ObservationSlam::addScan(const mrpt::obs::CObservation2DRangeScan& scan)
{
  MountedScan mounted = toMountedScan(scan, converter_, matching_);
  lastScan_s_ = mounted.scan.stamp_s;
  return slam_.addScan(std::move(mounted.scan), mounted.T_robot_sensor);
}
}  // namespace psmks
