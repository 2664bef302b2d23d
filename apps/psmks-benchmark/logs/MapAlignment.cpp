/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/MapAlignment.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/slam/CICP.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/mrpt/Convert.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
using mrpt::maps::CSimplePointsMap;
using mrpt::poses::CPose3D;
using mrpt::poses::CPosePDFGaussian;
using mrpt::slam::CICP;

/** Whether the odometry moves at some time; a log without odometry has none that does. */
bool isOdometryKnown(const std::vector<LogScan>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const LogScan& scan)
                     {
                       const Pose2 motion = scan.odometry.value_or(Pose2());
                       return motion.x_m != 0 || motion.y_m != 0 || motion.phi_rad != 0;
                     });
}

/** Where the robot is, and what it has mapped. */
class MapFollower
{
 public:
  MapFollower(mrpt::slam::CMetricMapsAlignmentAlgorithm& algorithm, const MapGrowth& growth)
      : algorithm_(algorithm), growth_(growth)
  {
    map_.insertionOptions.addToExistingPointsMap = true;
    map_.insertionOptions.disableDeletion = true;
  }

  void start(const LogScan& scan)
  {
    insert(scan);
    append(scan);
  }

  void follow(const LogScan& scan, const Eigen::Matrix3d& covariance)
  {
    pose_ = pose_ * scan.odometry.value_or(Pose2());
    align(scan, covariance);
    append(scan);
    const Pose2 moved = T_map_inserted_.inverse() * pose_;
    if (moved.translation().norm() > growth_.distance_m ||
        std::abs(moved.phi_rad) > growth_.angle_rad)
      insert(scan);
  }

  MapAlignment result;

 private:
  void align(const LogScan& scan, const Eigen::Matrix3d& covariance)
  {
    /** The threshold of MRPT's map builders. Unit: goodness. Definition: MRPT's default. */
    constexpr double kAccepted = 0.4;

    /** A correction from which on a match has jumped. Definition: more than an odometry errs from
     * one scan to the next. */
    constexpr double kFar_m = 0.5;
    CSimplePointsMap current;
    current.insertObservation(*toMrpt(scan.scan, scan.T_robot_sensor));
    CICP::TReturnInfo info;
    Stopwatch watch;
    const auto pdf =
        algorithm_.AlignPDF(&map_, &current, toMrpt(UncertainPose{pose_, covariance}), info);
    result.alignment_s += watch.lap_s();
    ++result.alignments;
    if (info.goodness <= kAccepted)
    {
      ++result.refused;
      return;
    }
    const Pose2 aligned = toPose2(pdf->getMeanVal());
    result.moved += (aligned.translation() - pose_.translation()).norm() > kFar_m ? 1 : 0;
    pose_ = aligned;
  }

  void insert(const LogScan& scan)
  {
    map_.insertObservation(*toMrpt(scan.scan, scan.T_robot_sensor), CPose3D(toMrpt(pose_)));
    T_map_inserted_ = pose_;
  }

  void append(const LogScan& scan)
  {
    PosedScan posed;
    posed.scan = scan.scan;
    posed.T_robot_sensor = scan.T_robot_sensor;
    posed.T_world_robot.pose = pose_;
    result.scans.push_back(std::move(posed));
  }

  mrpt::slam::CMetricMapsAlignmentAlgorithm& algorithm_;
  MapGrowth growth_;
  CSimplePointsMap map_;
  Pose2 pose_, T_map_inserted_;
};
}  // namespace

MapAlignment followByMap(const std::vector<LogScan>& scans,
                         mrpt::slam::CMetricMapsAlignmentAlgorithm& algorithm,
                         const MapGrowth& growth, const OdometryOptions& odometry)
{
  MapFollower follower(algorithm, growth);
  const bool isPredicted = isOdometryKnown(scans);
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    const Pose2 motion = scans[s].odometry.value_or(Pose2());
    if (s == 0)
      follower.start(scans[s]);
    else
      follower.follow(scans[s],
                      isPredicted ? odometryCovariance(motion, odometry) : Eigen::Matrix3d::Zero());
  }
  return std::move(follower.result);
}
}  // namespace psmks
