/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Simulation.h>
#include <psmks/sim/WaypointDriver.h>
#include <psmks/sim/World.h>

#include <algorithm>

namespace psmks
{
namespace
{
//   +-----------------------+ 10 m
//   |              end      |
//   |               |       |
//   |               |       |
//   | start --------+       |
//   +-----------------------+ 0, 0 to 10 m
const Route kCorner{{2, 2}, {7, 2}, {7, 7}};

World room()
{
  World world;
  world.addBox({5, 5}, {10, 10});
  return world;
}

Recording driveAlong(const Route& route, const Pose2& T_world_start, double duration_s)
{
  SimulationOptions options;
  options.duration_s = duration_s;
  options.laser.grid = BeamGrid::centered(kPi, 3);
  WaypointDriver driver({}, options.robot, route);
  return simulate(room(), T_world_start, driver, options);
}

double distanceToRoute_m(const Route& route, const Eigen::Vector2d& place_m)
{
  double nearest_m = 1e9;
  for (std::size_t p = 1; p < route.size(); ++p)
    nearest_m = std::min(nearest_m, World::Wall{route[p - 1], route[p]}.distance_m(place_m));
  return nearest_m;
}
}  // namespace

TEST(WaypointDriver, DrivesToTheEndAndStops)
{
  const Recording recording = driveAlong(kCorner, {2, 2, 0}, 60);
  EXPECT_LT(recording.scans.size(), 300U);  // the route ends well before the time is over
  EXPECT_LT((recording.scans.back().T_world_robot.translation() - kCorner.back()).norm(), 0.1);
  EXPECT_NEAR(recording.distance_m(), 10, 0.5);
  EXPECT_NEAR(recording.turns(), 0.25, 0.1);
}

TEST(WaypointDriver, KeepsToTheRoute)
{
  for (const RecordedScan& scan : driveAlong(kCorner, {2, 2, 0}, 60).scans)
    EXPECT_LT(distanceToRoute_m(kCorner, scan.T_world_robot.translation()), 0.25);
}

TEST(WaypointDriver, TurnsOnTheSpotWhereTheRouteLeadsBack)
{
  const Recording recording = driveAlong(kCorner, {2, 2, kPi}, 60);
  EXPECT_LT((recording.scans.back().T_world_robot.translation() - kCorner.back()).norm(), 0.1);
  // The robot turns by more than 90 degrees before it leaves its place.
  const auto turned = std::find_if(recording.scans.begin(), recording.scans.end(),
                                   [](const RecordedScan& scan)
                                   { return std::abs(scan.T_world_robot.phi_rad) < kPi / 2; });
  ASSERT_NE(turned, recording.scans.end());
  EXPECT_LT((turned->T_world_robot.translation() - kCorner.front()).norm(), 0.05);
}

TEST(WaypointDriver, DrivesTheSameWayThereAndBack)
{
  const Route there{{2, 2}, {6, 2}, {2, 2}};
  const Recording recording = driveAlong(there, {2, 2, 0}, 60);
  EXPECT_NEAR(recording.distance_m(), 8, 0.8);
  EXPECT_LT((recording.scans.back().T_world_robot.translation() - there.back()).norm(), 0.1);
}

TEST(WaypointDriver, DrivesNoFasterThanItShould)
{
  const Recording recording = driveAlong({{1, 2}, {9, 2}}, {1, 2, 0}, 60);
  EXPECT_NEAR(recording.distance_m() / (static_cast<double>(recording.scans.size()) / 10), 0.55,
              0.05);
}
}  // namespace psmks
