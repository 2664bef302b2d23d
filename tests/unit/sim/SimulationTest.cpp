/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Simulation.h>
#include <psmks/sim/World.h>
#include <tests/support/PoseMatcher.h>

#include <cmath>

namespace psmks
{
namespace
{
/** Commands the same speeds for a number of scans. */
class SteadyDriver : public Driver
{
 public:
  explicit SteadyDriver(const WheelSpeeds& speeds, int scans = 1 << 20)
      : speeds_(speeds), scansLeft_(scans)
  {
  }

  WheelSpeeds drive(const DriverView& view) override
  {
    --scansLeft_;
    bumps += view.bumped ? 1 : 0;
    return speeds_;
  }

  bool isDone() const override { return scansLeft_ <= 0; }

  int bumps = 0;

 private:
  WheelSpeeds speeds_;
  int scansLeft_;
};

//   +--------+ 4 m
//   |        |
//   | o ->   |   o = (1, 2)
//   |        |
//   +--------+ 0, 0 to 6 m
World room()
{
  World world;
  world.addBox({3, 2}, {6, 4});
  return world;
}

const Pose2 kStart{1, 2, 0};

SimulationOptions shortDrive(double duration_s)
{
  SimulationOptions options;
  options.duration_s = duration_s;
  options.laser.grid = BeamGrid::centered(kPi, 19);
  return options;
}

Recording drive(const WheelSpeeds& speeds, const SimulationOptions& options)
{
  SteadyDriver driver(speeds);
  return simulate(room(), kStart, driver, options);
}

bool areEqual(const Recording& a, const Recording& b)
{
  return std::equal(a.scans.begin(), a.scans.end(), b.scans.begin(), b.scans.end(),
                    [](const RecordedScan& s, const RecordedScan& t)
                    {
                      return s.simulated.scan.range_m == t.simulated.scan.range_m &&
                             isNearly(s.T_world_robot, t.T_world_robot, 0, 0) &&
                             isNearly(s.T_start_odometry, t.T_start_odometry, 0, 0);
                    });
}
}  // namespace

TEST(Simulation, TakesAScanEachPeriodFromTheFirstToTheLastMoment)
{
  SimulationOptions options = shortDrive(1);
  options.startStamp_s = 100;
  const Recording recording = drive({0.3, 0.3}, options);
  ASSERT_EQ(recording.scans.size(), 11U);
  EXPECT_NEAR(recording.scans[0].simulated.scan.stamp_s, 100, 1e-9);
  EXPECT_NEAR(recording.scans[10].simulated.scan.stamp_s, 101, 1e-9);
  EXPECT_TRUE(isNearly(recording.scans[0].T_world_robot, kStart, 0, 0));
}

TEST(Simulation, AScanIsTakenFromWhereTheRobotThenIs)
{
  SimulationOptions options = shortDrive(2);
  options.laser.rangeSigma_m = 0;
  options.T_robot_sensor = {0.2, 0, 0};
  const Recording recording = drive({0.3, 0.3}, options);
  const RecordedScan& last = recording.scans.back();
  EXPECT_GT(last.T_world_robot.x_m, 1.4);
  const double ahead_m = 6 - (last.T_world_robot * options.T_robot_sensor).x_m;
  EXPECT_NEAR(last.simulated.scan.range_m[9], ahead_m / std::cos(last.T_world_robot.phi_rad), 1e-9);
}

TEST(Simulation, EndsWithTheDriver)
{
  SteadyDriver driver({0.3, 0.3}, 5);
  EXPECT_EQ(simulate(room(), kStart, driver, shortDrive(10)).scans.size(), 5U);
}

TEST(Simulation, ARobotThatMeetsAWallStopsAtItsRadius)
{
  SteadyDriver driver({0.6, 0.6});
  const Recording recording = simulate(room(), kStart, driver, shortDrive(15));
  EXPECT_EQ(recording.collisions(), 1);  // it drives on against the wall, which counts once
  EXPECT_GT(driver.bumps, 10);
  EXPECT_TRUE(recording.scans.back().bumped);
  const double clearance_m =
      room().clearance_m(recording.scans.back().T_world_robot.translation(), 10, 0);
  EXPECT_GE(clearance_m, 0.38);
  EXPECT_LT(clearance_m, 0.40);
}

TEST(Simulation, ARobotLeavesWhatWalkedIntoIt)
{
  // A disc that is faster than the robot comes from 0.3 m behind and passes through it.
  World world = room();
  world.addMovingObject({0.2, 1, {{0.2, 2.3}, {6, 2.3}}});
  SteadyDriver driver({0.3, 0.3});
  const Recording recording = simulate(world, kStart, driver, shortDrive(5));
  EXPECT_EQ(recording.collisions(), 1);
  EXPECT_GT(recording.scans.back().T_world_robot.x_m, 1.5);
}

TEST(Simulation, TheSameSeedGivesTheSameRecording)
{
  SimulationOptions options = shortDrive(3);
  const Recording first = drive({0.3, 0.4}, options);
  EXPECT_TRUE(areEqual(first, drive({0.3, 0.4}, options)));
  options.seed = 2;
  EXPECT_FALSE(areEqual(first, drive({0.3, 0.4}, options)));
}

TEST(Simulation, AnotherLaserLeavesTheWheelsAsTheyWere)
{
  SimulationOptions options = shortDrive(3);
  const Recording first = drive({0.3, 0.4}, options);
  options.laser.grid = BeamGrid::centered(kPi, 361);
  options.laser.dropOutShare = 0.1;
  const Recording second = drive({0.3, 0.4}, options);
  EXPECT_TRUE(isNearly(first.scans.back().T_world_robot, second.scans.back().T_world_robot, 0, 0));
}

TEST(Simulation, ASweepIsTakenAlongTheTrueWay)
{
  SimulationOptions options = shortDrive(3);
  options.laser.rangeSigma_m = 0;
  options.robot.wheelNoise = 0;
  options.laser.sweepDuration_s = 0.05;
  options.laser.grid = BeamGrid(0, degToRad(0.5), 3);
  const Recording recording = drive({-0.1, 0.1}, options);  // 0.5 rad/s to the left
  const RecordedScan& scan = recording.scans[20];
  // Starts to turn at 0.05 s; at 2 s still before the right wall, or the upper one, 2 m off.
  const double phi_rad = scan.T_world_robot.phi_rad + degToRad(1) + 0.5 * 0.05;
  const double range_m = std::min(5 / std::cos(phi_rad), 2 / std::sin(phi_rad));
  EXPECT_NEAR(scan.simulated.scan.range_m[2], range_m, 1e-6);
  EXPECT_EQ(scan.simulated.scan.sweepDuration_s, 0.05);
}

TEST(Recording, CountsItsWayItsTurnsAndItsStandstill)
{
  SimulationOptions options = shortDrive(10);
  options.robot.wheelNoise = 0;
  options.robot.maxAcceleration_mps2 = 1e6;
  const Recording straight = drive({0.3, 0.3}, options);
  EXPECT_NEAR(straight.distance_m(), 3, 1e-9);
  EXPECT_NEAR(straight.turns(), 0, 1e-9);
  EXPECT_LT(straight.longestStandstill_s(), 1);

  const Recording onTheSpot = drive({0.2, -0.2}, options);  // 1 rad/s
  EXPECT_NEAR(onTheSpot.distance_m(), 0, 1e-9);
  EXPECT_NEAR(onTheSpot.turns(), 10 / (2 * kPi), 1e-9);
  EXPECT_NEAR(onTheSpot.longestStandstill_s(), 10, 1e-9);
}
}  // namespace psmks
