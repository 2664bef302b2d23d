/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
//                       | x = 5, from y = -10 to 10
//          | x = 2,     |
//          | up to y=0  |
//   o ->   |            |     o = (0, 0)
World wallBeforeWall() { return World({{{5, -10}, {5, 10}}, {{2, -10}, {2, 0}}}); }

/** A laser without errors, with rays 1 degree apart. */
LaserOptions exactLaser(int rays)
{
  LaserOptions laser;
  laser.grid = BeamGrid::centered(degToRad(rays - 1), rays);
  laser.maxRange_m = 30;
  laser.rangeSigma_m = 0;
  return laser;
}

SimulatedScan scanOf(const World& world, const Pose2& T_world_sensor, const LaserOptions& laser,
                     unsigned seed = 1)
{
  std::mt19937_64 random(seed);
  return castScan(world, T_world_sensor, laser, random);
}
}  // namespace

TEST(Laser, ReadsTheTrueRangesWithoutFaults)
{
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 0, 0}, exactLaser(3));
  EXPECT_NEAR(simulated.scan.range_m[0], 2 / std::cos(degToRad(1)), 1e-12);
  EXPECT_NEAR(simulated.scan.range_m[2], 5 / std::cos(degToRad(1)), 1e-12);
  EXPECT_EQ(simulated.objectOfRay[0], 1);
  EXPECT_EQ(simulated.objectOfRay[2], 0);
  EXPECT_EQ(simulated.noise_m, std::vector<double>(3, 0));
}

TEST(Laser, NoiseIsMeasuredMinusTrueRange)
{
  LaserOptions laser = exactLaser(61);
  const SimulatedScan exact = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  laser.rangeSigma_m = 0.01;
  laser.quantum_m = 0.05;
  laser.beamDivergence_rad = degToRad(0.5);
  const SimulatedScan faulty = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  for (std::size_t ray = 0; ray < 61; ++ray)
    EXPECT_NEAR(faulty.scan.range_m[ray] - exact.scan.range_m[ray], faulty.noise_m[ray], 1e-12);
}

// A moving mean of three: neighbours share two of three parts, and the variance stays.
TEST(Laser, SmoothedNoiseIsCorrelatedAlongTheScan)
{
  LaserOptions laser = exactLaser(61);
  laser.rangeSigma_m = 0.01;
  laser.smoothedRays = 3;
  double squares = 0, neighbours = 0, nextButTwo = 0;
  int rays = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    const std::vector<double> noise_m = scanOf(wallBeforeWall(), {0, 5, 0}, laser, seed).noise_m;
    for (std::size_t ray = 0; ray + 3 < noise_m.size(); ++ray, ++rays)
    {
      squares += noise_m[ray] * noise_m[ray];
      neighbours += noise_m[ray] * noise_m[ray + 1];
      nextButTwo += noise_m[ray] * noise_m[ray + 3];
    }
  }
  EXPECT_NEAR(std::sqrt(squares / rays), 0.01, 0.0002);
  EXPECT_NEAR(neighbours / squares, 2.0 / 3, 0.02);
  EXPECT_NEAR(nextButTwo / squares, 0, 0.02);
}

TEST(Laser, AScanErrsAsAWhole)
{
  const LaserOptions exact = exactLaser(61);
  const SimulatedScan truth = scanOf(wallBeforeWall(), {0, 5, 0}, exact);
  LaserOptions offset = exact, turned = exact;
  offset.scanOffsetSigma_m = 0.01;
  turned.scanBearingSigma_rad = degToRad(1);
  const SimulatedScan farther = scanOf(wallBeforeWall(), {0, 5, 0}, offset);
  EXPECT_GT(std::abs(farther.noise_m[0]), 1e-4);
  for (std::size_t ray = 0; ray < 61; ++ray)
    EXPECT_NEAR(farther.scan.range_m[ray] - truth.scan.range_m[ray], farther.noise_m[0], 1e-12);

  const SimulatedScan aside = scanOf(wallBeforeWall(), {0, 5, 0}, turned);
  EXPECT_GT(std::abs(aside.bearingOffset_rad), degToRad(0.05));
  const SimulatedScan same = scanOf(wallBeforeWall(), {0, 5, aside.bearingOffset_rad}, exact);
  for (std::size_t ray = 0; ray < 61; ++ray)
    EXPECT_NEAR(aside.scan.range_m[ray], same.scan.range_m[ray], 1e-9);
}

TEST(Laser, NoiseGrowsWithTheRangeByItsLaw)
{
  LaserOptions laser = exactLaser(61);
  laser.grid = BeamGrid::centered(degToRad(60), 4001);
  laser.rangeSigma_m = 0.005;
  laser.rangeSigmaPerMetre_m = 0.02;
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  double sum = 0;
  int returns = 0;
  for (std::size_t ray = 0; ray < 4001; ++ray)
  {
    if (simulated.objectOfRay[ray] == Hit::kNothing) continue;
    const double true_m = simulated.scan.range_m[ray] - simulated.noise_m[ray];
    sum += std::pow(simulated.noise_m[ray] / laser.rangeNoise().sigmaAt_m(true_m), 2);
    ++returns;
  }
  ASSERT_GT(returns, 1000);
  EXPECT_NEAR(sum / returns, 1, 0.1);
}

TEST(Laser, RangesAreMultiplesOfTheQuantumNextToTheTrueOne)
{
  LaserOptions laser = exactLaser(91);
  laser.quantum_m = 0.05;
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  for (std::size_t ray = 0; ray < 91; ++ray)
  {
    const double quanta = simulated.scan.range_m[ray] / 0.05;
    EXPECT_NEAR(quanta, std::round(quanta), 1e-9);
    EXPECT_LE(std::abs(simulated.noise_m[ray]), 0.025 + 1e-12);
  }
  EXPECT_GT(*std::max_element(simulated.noise_m.begin(), simulated.noise_m.end()), 0.02);
}

TEST(Laser, LosesItsShareOfReturns)
{
  constexpr unsigned kSeed = 3;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  LaserOptions laser = exactLaser(2);
  laser.grid = BeamGrid::centered(degToRad(90), 10001);
  laser.dropOutShare = 0.2;
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 1, 0}, laser, kSeed);
  const auto lost = std::count(simulated.scan.range_m.begin(), simulated.scan.range_m.end(), 0.0);
  EXPECT_NEAR(static_cast<double>(lost) / 10001, 0.2, 0.02);
  EXPECT_EQ(lost, std::count(simulated.objectOfRay.begin(), simulated.objectOfRay.end(),
                             static_cast<int>(Hit::kNothing)));
}

TEST(Laser, ABeamThatMeetsTwoObjectsReadsBetweenBoth)
{
  LaserOptions laser = exactLaser(3);
  laser.beamDivergence_rad = degToRad(0.5);
  // The middle one of three beams, 1 degree apart, grazes the edge of the near wall, 0.1 degree on
  // the near one's side: five of nine rays meet the far wall 3 m behind, or four.
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 0, degToRad(-0.1)}, laser);
  const double mixed_m = simulated.scan.range_m[1];
  EXPECT_GT(mixed_m, 2.5);
  EXPECT_LT(mixed_m, 4.5);
  EXPECT_NEAR(simulated.scan.range_m[0], 2, 0.01);
  EXPECT_NEAR(simulated.scan.range_m[2], 5, 0.01);
  EXPECT_NEAR(simulated.noise_m[1], mixed_m - 2, 0.01);
}

TEST(Laser, ABeamHalfInTheVoidReadsWhatItMeets)
{
  LaserOptions laser = exactLaser(3);
  laser.maxRange_m = 4;
  laser.beamDivergence_rad = degToRad(0.5);
  const SimulatedScan simulated = scanOf(wallBeforeWall(), {0, 0, degToRad(-0.1)}, laser);
  EXPECT_NEAR(simulated.scan.range_m[1], 2, 0.01);
  EXPECT_EQ(simulated.scan.range_m[2], 0);
}

//   The sensor turns left at w = 1 rad/s before a wall x = 5. Ray i leaves at t_i on the bearing
//   b_i + w t_i of the world, so the wall lies at 5 / cos(b_i + w t_i) instead of 5 / cos(b_i).
TEST(Laser, ATurningSensorSeesAStraightWallBent)
{
  constexpr double kRate_radps = 1, kSweep_s = 0.05;
  LaserOptions laser = exactLaser(61);
  laser.sweepDuration_s = kSweep_s;
  std::mt19937_64 random(1);
  const auto turning = [](double sinceFirstRay_s) {
    return Pose2{0, 1, kRate_radps * sinceFirstRay_s};
  };
  const SimulatedScan simulated = castScan(wallBeforeWall(), turning, 0, laser, random);
  EXPECT_EQ(simulated.scan.sweepDuration_s, kSweep_s);
  for (int ray = 31; ray < 61; ++ray)
  {
    const double bearing_rad = laser.grid.bearing_rad(ray) + kRate_radps * kSweep_s * ray / 60;
    EXPECT_NEAR(simulated.scan.range_m[static_cast<std::size_t>(ray)], 5 / std::cos(bearing_rad),
                1e-9);
  }
}

// The scanner comes nearer to a wall 5 m ahead at 1 m/s: the rays of the second turn, 0.1 s later,
// are 10 cm shorter.
TEST(Laser, RaysOfTheSecondTurnAreCastLater)
{
  LaserOptions laser = exactLaser(61);
  laser.grid = BeamGrid(0, 1e-5, 11);
  laser.interleavedTurns = 2;
  laser.turn_s = 0.1;
  EXPECT_DOUBLE_EQ(laser.duration_s(), 0.1);
  std::mt19937_64 random(1);
  const auto ahead = [](double sinceFirstRay_s) { return Pose2{sinceFirstRay_s, 1, 0}; };
  const SimulatedScan simulated = castScan(wallBeforeWall(), ahead, 0, laser, random);
  EXPECT_EQ(simulated.scan.interleavedTurns, 2);
  EXPECT_EQ(simulated.scan.turn_s, 0.1);
  for (std::size_t ray = 0; ray < 11; ++ray)
    EXPECT_NEAR(simulated.scan.range_m[ray], ray % 2 == 0 ? 5 : 4.9, 1e-6);
}

TEST(Laser, EachRayMeetsAMovingObjectWhereItThenIs)
{
  // A disc ahead goes away at 1 m/s; all rays point ahead within a millionth of a degree.
  World world;
  world.addMovingObject({0.2, 1, {{2, 0}, {8, 0}}});
  LaserOptions laser = exactLaser(2);
  laser.grid = BeamGrid(0, 1e-5, 11);
  laser.sweepDuration_s = 0.1;
  std::mt19937_64 random(1);
  const auto atRest = [](double) { return Pose2{}; };
  const SimulatedScan simulated = castScan(world, atRest, 2, laser, random);
  EXPECT_NEAR(simulated.scan.range_m.front(), 3.8, 1e-6);
  EXPECT_NEAR(simulated.scan.range_m.back(), 3.9, 1e-6);
}

TEST(Laser, TheNoiseOfARayIsTheSameAtEveryMaximumRange)
{
  LaserOptions laser = exactLaser(91);
  laser.rangeSigma_m = 0.01;
  const SimulatedScan far = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  laser.maxRange_m = 5.5;
  const SimulatedScan near = scanOf(wallBeforeWall(), {0, 1, 0}, laser);
  EXPECT_EQ(near.scan.range_m.front(), far.scan.range_m.front());
  EXPECT_EQ(near.scan.range_m.back(), 0);
  EXPECT_EQ(near.scan.range_m[50], far.scan.range_m[50]);
}
}  // namespace psmks
