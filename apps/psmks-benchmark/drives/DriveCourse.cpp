/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/drives/DriveCourse.h>
#include <apps/psmks-benchmark/experiments/MethodRun.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/slam/PoseGraph.h>
#include <psmks/slam/ScanMap.h>
#include <psmks/slam/TrajectoryBuilder.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <utility>

namespace psmks
{
namespace
{
constexpr std::size_t kTenths = 10;

/** The memory of this process that is in use, as Linux tells it; 0 elsewhere. */
double residentMemory_MB()
{
  std::ifstream file("/proc/self/statm");
  double total_pages = 0, resident_pages = 0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

std::size_t countKeyframes(const std::vector<PosedScan>& scans)
{
  return static_cast<std::size_t>(std::count_if(
      scans.begin(), scans.end(), [](const PosedScan& scan) { return scan.isReference; }));
}

/** Gives every scan of a drive to the builder, and takes the time. */
std::vector<DriveStretch> follow(const Recording& recording, TrajectoryBuilder& builder,
                                 const std::function<void(double)>& progress)
{
  const auto& scans = recording.scans;
  const double before_MB = residentMemory_MB();
  std::vector<DriveStretch> tenths(kTenths);
  double way_m = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    std::optional<Pose2> odometry;
    if (s > 0)
    {
      odometry = scans[s - 1].T_start_odometry.inverse() * scans[s].T_start_odometry;
      way_m +=
          (scans[s].T_world_robot.translation() - scans[s - 1].T_world_robot.translation()).norm();
    }
    DriveStretch& tenth = tenths[s * kTenths / scans.size()];
    Stopwatch watch;
    builder.add(scans[s].simulated.scan, recording.T_robot_sensor, odometry);
    tenth.scan_s += watch.lap_s();
    tenth.way_m = way_m;
    ++tenth.scans;
    const bool isLast = (s + 1) * kTenths / scans.size() != s * kTenths / scans.size();
    if (!isLast) continue;
    tenth.scan_s /= static_cast<double>(tenth.scans);
    tenth.keyframes = countKeyframes(builder.scans());
    tenth.memory_MB = residentMemory_MB() - before_MB;
    progress(static_cast<double>(s + 1) / static_cast<double>(scans.size()));
  }
  return tenths;
}

bool isWrong(const ReferenceMatch& link, const Pose2& T_ref_cur, const ReferencePolicy& policy)
{
  /** Errors up to which a link is not wrong. Definition: those of silent errors in the paper's
   * experiments. */
  constexpr double kWrong_m = 0.1, kWrong_rad = degToRad(2);

  /** Errors up to which a link claims them. Unit: standard deviations. Definition: one of two
   * million normal errors is larger. */
  constexpr double kSigmas = 5;
  const PoseLink claimed{0, 1, link.T_ref_cur.pose, policy.linkInformation(link.information)};
  const Eigen::Vector3d error = linkError(claimed, Pose2(), T_ref_cur);
  return (error.head<2>().norm() > kWrong_m || std::abs(error.z()) > kWrong_rad) &&
         error.dot(claimed.information * error) > kSigmas * kSigmas;
}

std::size_t countWrongLinks(const Recording& recording, const std::vector<PosedScan>& scans,
                            const ReferencePolicy& policy)
{
  std::size_t wrong = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
    for (const ReferenceMatch& link : scans[s].links)
    {
      const Pose2 T_ref_cur = recording.scans[link.reference].T_world_robot.inverse() *
                              recording.scans[s].T_world_robot;
      wrong += isWrong(link, T_ref_cur, policy) ? 1 : 0;
    }
  return wrong;
}

/** Counts the segments of the map the middle of which stands on no wall. */
std::size_t countOffWalls(const World& world, const Pose2& T_world_start, const ScanMap& map)
{
  /** Walls are as far from where the map shows them at most. Definition: above the errors of
   * settled poses, below the size of a person. */
  constexpr double kOnWall_m = 0.3;
  World walls(world.walls());
  const WorldIndex index(std::move(walls));
  return static_cast<std::size_t>(std::count_if(
      map.walls.begin(), map.walls.end(),
      [&](const ScanMap::Wall& wall)
      {
        const Eigen::Vector2d middle_m = T_world_start * ((wall.from_m + wall.to_m) / 2);
        return index.clearance_m(middle_m, kOnWall_m, 0) >= kOnWall_m;
      }));
}

}  // namespace

DriveCourse followDrive(const Drive& drive, const SlamOptions& options,
                        const std::function<void(double)>& progress)
{
  const Recording& recording = drive.recording;
  TrajectoryBuilder builder(makePairMatcher("psmks", options.matching.matcher), options.reference,
                            options.odometry);
  DriveCourse course;
  course.tenths = follow(recording, builder, progress);
  builder.optimise();
  const Pose2& T_world_start = recording.scans.front().T_world_robot;
  std::vector<Pose2> T_world_robot;
  for (const PosedScan& scan : builder.scans())
    T_world_robot.push_back(T_world_start * scan.T_world_robot.pose);
  std::vector<std::size_t> all(builder.scans().size());
  std::iota(all.begin(), all.end(), 0);
  course.drift = driftFigures(recording, T_world_robot, all);
  const DriftBound floor(drive.site.world, recording, drive.simulation);
  course.floor = driftFigures(recording, floor.settledPoses(driftBoundSteps(builder.scans())), all);
  course.wrongLinks =
      countWrongLinks(recording, builder.scans(), ReferencePolicy(options.reference));
  course.segmentsOffWalls = countOffWalls(drive.site.world, T_world_start,
                                          makeScanMap(builder.scans(), options.matching.matcher));
  return course;
}
}  // namespace psmks
