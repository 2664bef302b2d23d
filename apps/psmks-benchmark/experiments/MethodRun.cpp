/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/MethodRun.h>
#include <psmks/eval/Statistics.h>
#include <psmks/slam/ScanMap.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kSilentError_m = 0.10;
constexpr double kSilentError_rad = degToRad(2);

constexpr double kWallEnd_m = 0.03;

Pose2 trueMotion(const Recording& recording, std::size_t from, std::size_t to)
{
  return recording.scans[from].T_world_robot.inverse() * recording.scans[to].T_world_robot;
}

/** Computes the trajectory, and the pose of each scan when it was added. */
void follow(const Recording& recording, TrajectoryBuilder& builder,
            std::vector<Pose2>& T_world_robot)
{
  const Pose2& T_world_start = recording.scans.front().T_world_robot;
  const auto& scans = recording.scans;
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    std::optional<Pose2> odometry;
    if (s > 0) odometry = scans[s - 1].T_start_odometry.inverse() * scans[s].T_start_odometry;
    const PosedScan& posed =
        builder.add(scans[s].simulated.scan, recording.T_robot_sensor, odometry);
    T_world_robot.push_back(T_world_start * posed.T_world_robot.pose);
  }
  builder.optimise();
}

void countMatch(const Recording& recording, const ReferenceMatch& match, std::size_t scan,
                MethodFigures& figures)
{
  if (!match.result.usable())
  {
    ++figures.failures;
    return;
  }
  if (match.result.status == MatchStatus::Degenerate)
  {
    ++figures.degenerate;
    return;
  }
  const Pose2 error = trueMotion(recording, match.reference, scan).inverse() * match.T_ref_cur.pose;
  const double error_m = error.translation().norm(), error_rad = std::abs(error.phi_rad);
  figures.silentErrors += error_m > kSilentError_m || error_rad > kSilentError_rad ? 1 : 0;
  figures.worstMatch_m = std::max(figures.worstMatch_m, error_m);
  figures.worstMatch_rad = std::max(figures.worstMatch_rad, error_rad);
}

MethodFigures countMatches(const Recording& recording, const std::vector<PosedScan>& scans)
{
  MethodFigures figures;
  std::vector<double> segmentation_s, match_s;
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    for (const auto& link : scans[s].links) countMatch(recording, link, s, figures);
    for (const auto& match : scans[s].matches)
    {
      countMatch(recording, match, s, figures);
      segmentation_s.push_back(match.result.times.segmentation_s);
      match_s.push_back(match.time_s - match.result.times.segmentation_s);
    }
    figures.matches += scans[s].isMatched() ? 1 : 0;
  }
  figures.meanSegmentation_s = mean(segmentation_s);
  figures.meanMatch_s = mean(match_s);
  return figures;
}

std::vector<std::size_t> matchedScans(const std::vector<PosedScan>& scans)
{
  std::vector<std::size_t> matched;
  for (std::size_t s = 0; s < scans.size(); ++s)
    if (scans[s].isMatched()) matched.push_back(s);
  return matched;
}

double shareOfEndsOnWalls(const World& world, const Pose2& T_world_start, const ScanMap& map)
{
  int ends = 0, onWalls = 0;
  for (const auto& wall : map.walls)
    for (const auto& end_m : {wall.from_m, wall.to_m})
    {
      ++ends;
      onWalls += world.clearance_m(T_world_start * end_m, kWallEnd_m, 0) < kWallEnd_m ? 1 : 0;
    }
  return ends > 0 ? static_cast<double>(onWalls) / ends : 0;
}
}  // namespace

DriftFigures driftFigures(const Recording& recording, const std::vector<Pose2>& T_world_robot,
                          const std::vector<std::size_t>& scans)
{
  DriftFigures drift;
  for (const std::size_t s : scans)
  {
    const Pose2& truth = recording.scans[s].T_world_robot;
    const double error_m = (T_world_robot[s].translation() - truth.translation()).norm();
    const double error_rad = std::abs(wrapAngle(T_world_robot[s].phi_rad - truth.phi_rad));
    drift.mean_m += error_m / static_cast<double>(scans.size());
    drift.mean_rad += error_rad / static_cast<double>(scans.size());
    drift.max_m = std::max(drift.max_m, error_m);
    drift.max_rad = std::max(drift.max_rad, error_rad);
  }
  return drift;
}

std::vector<DriftBoundStep> driftBoundSteps(const std::vector<PosedScan>& scans)
{
  std::vector<DriftBoundStep> steps(scans.size());
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    if (scans[s].isMatched()) steps[s].reference = scans[s].decidingMatch()->reference;
    steps[s].joinsMap = scans[s].isReference;
    for (const auto& link : scans[s].links) steps[s].links.push_back(link.reference);
  }
  return steps;
}

std::vector<Pose2> odometryPoses(const Recording& recording)
{
  const Pose2& T_world_start = recording.scans.front().T_world_robot;
  std::vector<Pose2> poses;
  for (const auto& scan : recording.scans) poses.push_back(T_world_start * scan.T_start_odometry);
  return poses;
}

MethodRun runMethod(const Drive& drive, const Method& method, const MatcherOptions& options,
                    const OdometryOptions& odometry)
{
  const Recording& recording = drive.recording;
  TrajectoryBuilder builder(makePairMatcher(method.matcher, options), method.reference, odometry);
  MethodRun run;
  run.method = method;
  follow(recording, builder, run.T_world_robot);
  run.scans = builder.scans();
  run.matched = matchedScans(run.scans);
  const Pose2& T_world_start = recording.scans.front().T_world_robot;

  const DriftBound floor(drive.site.world, recording, drive.simulation);
  run.figures = countMatches(recording, run.scans);
  run.figures.drift = driftFigures(recording, run.T_world_robot, run.matched);
  run.figures.odometryDrift = driftFigures(recording, odometryPoses(recording), run.matched);
  run.figures.boundDrift =
      driftFigures(recording, floor.poses(driftBoundSteps(run.scans)), run.matched);
  run.figures.wallEndsShare =
      shareOfEndsOnWalls(drive.site.world, T_world_start, makeScanMap(run.scans, options));
  return run;
}
}  // namespace psmks
