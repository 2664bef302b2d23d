/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/sim/DriftBound.h>

#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr double kStep_m = 0.5;
constexpr double kRangeSigma_m = 0.01;
constexpr std::size_t kScans = 6;

/** A robot that drives straight on through the small room; its wheels count 2 % more than it
 * drives. */
Recording straightDrive(const World& world, unsigned seed)
{
  std::mt19937_64 random(seed);
  LaserOptions laser;
  laser.maxRange_m = 30;
  laser.rangeSigma_m = kRangeSigma_m;
  Recording recording;
  for (std::size_t step = 0; step < kScans; ++step)
  {
    const double driven_m = kStep_m * static_cast<double>(step);
    RecordedScan scan;
    scan.T_world_robot = {-1.5 + driven_m, -2, 0};
    scan.T_start_odometry = {1.02 * driven_m, 0, 0};
    scan.simulated = castScan(world, scan.T_world_robot, laser, random);
    recording.scans.push_back(scan);
  }
  return recording;
}

SimulationOptions simulation()
{
  SimulationOptions options;
  options.laser.rangeSigma_m = kRangeSigma_m;
  return options;
}

double error_m(const Recording& recording, const std::vector<Pose2>& poses, std::size_t scan)
{
  return (poses[scan].translation() - recording.scans[scan].T_world_robot.translation()).norm();
}

/** Each scan matched against the one before it. */
std::vector<DriftBoundStep> everyScanMatched(std::size_t scans)
{
  std::vector<DriftBoundStep> steps(scans);
  for (std::size_t scan = 1; scan < scans; ++scan) steps[scan].reference = scan - 1;
  return steps;
}

/** The bound of the first two scans. The robot does not turn, so the axes of the first one are
 * those of the world. */
PoseBound boundOfFirstMatch(const World& world, const Recording& recording)
{
  const RecordedScan &ref = recording.scans[0], &cur = recording.scans[1];
  return poseBound(world, ref.T_world_robot, ref.simulated, cur.T_world_robot, cur.simulated,
                   simulation().laser.rangeNoise());
}
}  // namespace

TEST(DriftBound, IsTheOdometryWhereNothingIsMatched)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 1);
  const auto poses =
      DriftBound(world, recording, simulation()).poses(std::vector<DriftBoundStep>(kScans));
  ASSERT_EQ(poses.size(), kScans);
  EXPECT_NEAR(error_m(recording, poses, kScans - 1), 0.02 * kStep_m * (kScans - 1), 1e-12);
}

// The squared Mahalanobis distance of an error with the covariance of the bound is chi-squared
// distributed with 3 degrees of freedom: mean 3, variance 6. The mean over 100 drives then has a
// standard deviation of 0.24, and 4 of them are allowed. Wheels that tell nothing leave the error
// to the scans alone.
TEST(DriftBound, TheErrorOfOneMatchHasTheCovarianceOfThePoseBound)
{
  constexpr int kDrives = 100;
  const World world = World::smallRoom();
  SimulationOptions options = simulation();
  options.robot.wheelNoise = 1e3;
  double sum = 0;
  for (unsigned seed = 1; seed <= kDrives; ++seed)
  {
    const Recording recording = straightDrive(world, seed);
    const Pose2 pose = DriftBound(world, recording, options).poses(everyScanMatched(2)).back();
    const Pose2& truth = recording.scans[1].T_world_robot;
    const Eigen::Vector3d error(pose.x_m - truth.x_m, pose.y_m - truth.y_m,
                                wrapAngle(pose.phi_rad - truth.phi_rad));
    sum += error.dot(boundOfFirstMatch(world, recording).information * error);
  }
  EXPECT_NEAR(sum / kDrives, 3, 4 * std::sqrt(6.0 / kDrives));
}

// Five matches of 361 rays with 1 cm of noise. The standard deviation of one of them is 1 mm and
// its errors cancel in part along the chain, so that the drift at its end is a few millimetres,
// while odometry alone is 5 cm off.
TEST(DriftBound, IsMillimetresWhereEveryScanIsMatched)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 1);
  const auto poses = DriftBound(world, recording, simulation()).poses(everyScanMatched(kScans));
  EXPECT_LT(error_m(recording, poses, kScans - 1), 0.02);
}

// Without links between keyframes nothing settles later.
TEST(DriftBound, SettledPosesAreTheFirstOnesWhereNothingLinksKeyframes)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 2);
  const DriftBound bound(world, recording, simulation());
  const auto steps = everyScanMatched(kScans);
  const auto poses = bound.poses(steps), settled = bound.settledPoses(steps);
  ASSERT_EQ(settled.size(), kScans);
  for (std::size_t scan = 0; scan < kScans; ++scan)
    EXPECT_NEAR((settled[scan].translation() - poses[scan].translation()).norm(), 0, 1e-12) << scan;
}

//   0 -- 1 -- 2 -- 3 -- 4 -- 5     each is matched against the one before, and the last one
//   '----'----'----'---------'     against all: the poses of all of them follow from all matches
TEST(DriftBound, ALaterLinkSettlesTheKeyframesBeforeIt)
{
  const World world = World::smallRoom();
  const Recording recording = straightDrive(world, 3);
  auto steps = everyScanMatched(kScans);
  for (DriftBoundStep& step : steps) step.joinsMap = true;
  steps[5].links = {0, 1, 2, 3};
  const DriftBound bound(world, recording, simulation());
  const auto linked = bound.settledPoses(steps);
  double sum_m = 0, unlinked_m = 0;
  for (auto& step : steps) step.links.clear();
  const auto unlinked = bound.settledPoses(steps);
  for (std::size_t scan = 1; scan < kScans; ++scan)
  {
    sum_m += error_m(recording, linked, scan);
    unlinked_m += error_m(recording, unlinked, scan);
    EXPECT_LT(error_m(recording, linked, scan), 0.01) << scan;
  }
  EXPECT_NE(sum_m, unlinked_m) << "links count";
}
}  // namespace psmks
