/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/StepPairs.h>
#include <psmks/eval/CommonPoses.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <optional>

namespace psmks
{
namespace
{
/** The poses of the robot by odometry at all scans. */
Trajectory odometryPath(const Log& log)
{
  Trajectory path;
  Pose2 pose;
  for (const LogScan& scan : log.scans)
  {
    if (!path.empty()) pose = pose * scan.odometry.value_or(Pose2());
    path.push_back({scan.scan.stamp_s, pose});
  }
  return path;
}

/** The true poses of the robot at all scans of a path; nothing if the truth was not measured there.
 */
std::vector<std::optional<Pose2>> truePoses(const Trajectory& path, const Trajectory& truth)
{
  std::vector<std::optional<Pose2>> poses(path.size());
  std::size_t scan = 0;
  for (const CommonPose& common : commonPoses(path, truth))
  {
    while (path[scan].stamp_s != common.stamp_s) ++scan;
    if (common.isMeasured) poses[scan] = common.T_true;
    ++scan;
  }
  return poses;
}

/** The motion between two scans of a log, measured by odometry. */
UncertainPose measuredMotion(const Log& log, const Trajectory& path, std::size_t from,
                             std::size_t to, const OdometryOptions& options)
{
  const Pose2 motion = path[from].pose.inverse() * path[to].pose;
  const auto scan = [&log](std::size_t i) { return log.scans.begin() + static_cast<long>(i); };
  const bool isMeasured = std::all_of(scan(from + 1), scan(to + 1),
                                      [](const LogScan& s) { return s.odometry.has_value(); });
  return {motion,
          isMeasured ? odometryCovariance(motion, options) : unknownMotionCovariance(options)};
}
}  // namespace

StepPairs stepPairs(const Log& log, int every, const OdometryOptions& odometry)
{
  StepPairs steps;
  steps.odometry.name = kOdometryGuess;
  if (!log.groundTruth) return steps;

  const Trajectory path = odometryPath(log);
  const auto truth = truePoses(path, *log.groundTruth);
  const auto stride = static_cast<std::size_t>(every);
  for (std::size_t from = 0, to = stride; to < path.size(); from = to, to += stride)
  {
    const LogScan &reference = log.scans[from], &current = log.scans[to];
    const Pose2 T_sensor_ref = reference.T_robot_sensor.inverse();
    if (!truth[from] || !truth[to])
    {
      ++steps.withoutTruth;
      continue;
    }
    const Pose2 T_ref_cur =
        T_sensor_ref * truth[from]->inverse() * *truth[to] * current.T_robot_sensor;
    if (overlap(reference.scan, current.scan, T_ref_cur) < kLeastOverlap)
    {
      ++steps.withoutOverlap;
      continue;
    }
    const UncertainPose guess = conjugated(measuredMotion(log, path, from, to, odometry),
                                           T_sensor_ref, current.T_robot_sensor.inverse());
    steps.pairs.push_back(
        {static_cast<int>(to), T_ref_cur, guess.pose, reference.scan, current.scan});
    steps.odometry.ofPair.push_back({guess.pose, guess.covariance});
  }
  return steps;
}
}  // namespace psmks
