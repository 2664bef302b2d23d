/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Summary.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/eval/Statistics.h>

namespace psmks
{
namespace
{
std::size_t occupiedCells(const std::vector<PosedScan>& scans)
{
  OccupiedCells cells;
  if (scans.empty()) return 0;
  const Pose2 T_first_world = scans.front().T_world_sensor().inverse();
  for (const auto& scan : scans) cells.add(scan.scan, T_first_world * scan.T_world_sensor());
  return cells.count();
}

/** The length of the way from place to place, each the first that is far enough from the one
 * before.
 */
double pathLength_m(const std::vector<PosedScan>& scans)
{
  /** Least distance of two places. Unit: m. Definition: more than the scatter of the matches of a
   * robot that stands. */
  constexpr double kFarEnough_m = 0.1;
  double length_m = 0;
  Eigen::Vector2d last_m = Eigen::Vector2d::Zero();  // where the first scan was
  for (const auto& scan : scans)
  {
    const Eigen::Vector2d here_m = scan.T_world_robot.pose.translation();
    const double step_m = (here_m - last_m).norm();
    if (step_m < kFarEnough_m) continue;
    length_m += step_m;
    last_m = here_m;
  }
  return length_m;
}

void addTimes(const std::vector<PosedScan>& scans, Summary& summary)
{
  std::vector<double> match_s, segmentation_s;
  for (const auto& scan : scans)
  {
    for (const auto& match : scan.matches)
    {
      match_s.push_back(match.time_s);
      segmentation_s.push_back(match.result.times.segmentation_s);
    }
  }
  constexpr double kP95 = 0.95;
  summary.matchMedian_s = median(match_s);
  summary.matchP95_s = quantile(match_s, kP95);
  summary.segmentationMedian_s = median(segmentation_s);
}

std::optional<TrajectoryError> errorAgainst(const Trajectory& truth,
                                            const std::vector<PosedScan>& scans)
{
  const TrajectoryError error = trajectoryError(trajectoryOf(scans), truth);
  if (error.poses == 0) return std::nullopt;
  return error;
}
}  // namespace

std::size_t Summary::failures() const
{
  std::size_t sum = 0;
  for (const auto& [status, count] : failed) sum += count;
  return sum;
}

Summary summarise(const std::vector<PosedScan>& scans, const std::optional<Trajectory>& groundTruth)
{
  Summary summary;
  summary.scans = scans.size();
  for (const auto& scan : scans)
  {
    summary.references += scan.isReference;
    summary.unmatched += !scan.isMatched();
    summary.matches += scan.matches.size();
    for (const ReferenceMatch& match : scan.matches)
      ++(match.result.usable() ? summary.usable : summary.failed)[toString(match.result.status)];
  }
  if (!scans.empty()) --summary.unmatched;
  summary.pathLength_m = pathLength_m(scans);
  addTimes(scans, summary);
  summary.occupiedCells = occupiedCells(scans);
  summary.odometryJumps = odometryJumps(scans);
  if (groundTruth) summary.error = errorAgainst(*groundTruth, scans);
  return summary;
}

Trajectory trajectoryOf(const std::vector<PosedScan>& scans)
{
  Trajectory trajectory;
  for (const auto& scan : scans) trajectory.push_back({scan.stamp_s(), scan.T_world_robot.pose});
  return trajectory;
}

Trajectory odometryOf(const std::vector<PosedScan>& scans)
{
  Trajectory trajectory;
  for (const auto& scan : scans) trajectory.push_back({scan.stamp_s(), scan.T_world_odometry});
  return trajectory;
}
}  // namespace psmks
