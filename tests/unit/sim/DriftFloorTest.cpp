/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/DriftFloor.h>

#include <random>

namespace psmks
{
namespace
{
constexpr double kStep_m = 0.5;

/** A robot that drives five steps straight on through the small room; its wheels count 2 % more
 * than it drives. */
Recording straightDrive(const World& world, double rangeSigma_m, unsigned seed)
{
  std::mt19937_64 random(seed);
  LaserOptions laser;
  laser.maxRange_m = 30;
  laser.rangeSigma_m = rangeSigma_m;
  Recording recording;
  for (int step = 0; step < 6; ++step)
  {
    RecordedScan scan;
    scan.T_world_robot = {-1.5 + kStep_m * step, -2, 0};
    scan.T_start_odometry = {1.02 * kStep_m * step, 0, 0};
    scan.simulated = castScan(world, scan.T_world_robot, laser, random);
    recording.scans.push_back(scan);
  }
  return recording;
}

SimulationOptions simulation(double rangeSigma_m)
{
  SimulationOptions options;
  options.laser.rangeSigma_m = rangeSigma_m;
  return options;
}

double error_m(const Recording& recording, const std::vector<Pose2>& poses, std::size_t scan)
{
  return (poses[scan].translation() - recording.scans[scan].T_world_robot.translation()).norm();
}
}  // namespace

TEST(DriftFloor, IsTheOdometryWhereNothingIsMatched)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 0.01, 1);
  const auto poses =
      DriftFloor(world, recording, simulation(0.01)).poses(std::vector<FloorStep>(6));
  EXPECT_EQ(poses.size(), 6U);
  EXPECT_NEAR(error_m(recording, poses, 5), 0.02 * kStep_m * 5, 1e-12);
}

TEST(DriftFloor, IsMillimetresWhereEveryScanIsMatched)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 0.01, 1);
  std::vector<FloorStep> before(6);
  for (std::size_t scan = 1; scan < 6; ++scan) before[scan].reference = scan - 1;
  const auto poses = DriftFloor(world, recording, simulation(0.01)).poses(before);
  EXPECT_LT(error_m(recording, poses, 5), 0.02);
  EXPECT_GT(error_m(recording, poses, 5), 0);
}
}  // namespace psmks
