/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmark/benchmark.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/sim/Worlds.h>

#include <random>

namespace psmks
{
namespace
{
/** Random poses of a site at which a robot has space. */
std::vector<Pose2> freePoses(const Site& site)
{
  constexpr int kPoses = 200;
  constexpr double kRobot_m = 0.4;
  std::mt19937_64 random(1);
  std::vector<Pose2> poses;
  while (poses.size() < kPoses) poses.push_back(site.world.randomFreePose(kRobot_m, random));
  return poses;
}

/** Casts scans of 361 rays over 180 degrees with a range of 30 m and without noise. The time is
 * that of one scan. */
void castingAScan(benchmark::State& state, const char* siteName)
{
  constexpr int kRays = 361;
  constexpr double kRange_m = 30;
  const Site site = makeSite(siteName, 1);
  const WorldIndex index(site.world);
  const std::vector<Pose2> poses = freePoses(site);
  const BeamGrid grid = BeamGrid::centered(kPi, kRays);
  std::size_t scan = 0;
  for (auto _ : state)
  {
    const Pose2& pose = poses[scan++ % poses.size()];
    const Eigen::Matrix2d R_world_sensor = pose.rotation();
    for (int ray = 0; ray < kRays; ++ray)
      benchmark::DoNotOptimize(
          index.cast(pose.translation(), R_world_sensor * grid.direction(ray), kRange_m, 0));
  }
}

BENCHMARK_CAPTURE(castingAScan, campus, "campus")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(castingAScan, curved, "curved")->Unit(benchmark::kMicrosecond);
}  // namespace
}  // namespace psmks
