/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/SensorSurvey.h>
#include <tests/support/Scenes.h>

#include <cmath>
#include <random>

namespace psmks
{
namespace
{
/** A scanner in the room of officeRoom(), 361 rays over 180 degrees. */
class SensorSurveyTest : public testing::Test
{
 protected:
  Scan scanAt(const Pose2& pose, double sigma_m = 0.01)
  {
    return castScan(officeRoom(), pose, BeamGrid::centered(kPi, 361), 30, sigma_m, rng_);
  }

  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(rng_); }

  std::mt19937 rng_{3};
  SensorSurvey survey_{MatcherOptions()};
};
}  // namespace

TEST_F(SensorSurveyTest, FindsTheNoiseOfAStandingScanner)
{
  for (int i = 0; i < 200; ++i) survey_.add(scanAt({}));
  const SensorReport report = survey_.report();
  EXPECT_EQ(report.scans, 200);
  EXPECT_EQ(report.standing.scans, 199);
  EXPECT_NEAR(report.standing.noise.sigmaAt_m(3), 0.01, 0.0005);
  EXPECT_NEAR(report.walls.noise.sigmaAt_m(3), 0.01, 0.001);
  EXPECT_NEAR(report.standing.raysPerReading, 1, 0.1);
  EXPECT_EQ(&report.best(), &report.standing);
  ASSERT_TRUE(report.wholeScan);
  EXPECT_LT(report.wholeScan->sigma_m, 0.0005);
  EXPECT_LT(report.wholeScan->sigma_rad, degToRad(0.02));
}

TEST_F(SensorSurveyTest, FindsThatWholeScansAreTurned)
{
  for (int i = 0; i < 200; ++i) survey_.add(scanAt({0, 0, normal(degToRad(0.15))}));
  const SensorReport report = survey_.report();
  ASSERT_TRUE(report.wholeScan);
  EXPECT_NEAR(radToDeg(report.wholeScan->sigma_rad), 0.15, 0.03);
  EXPECT_NE(report.sensorFile().find("[psmks.whole_scan]\nsigma_m = 0"), std::string::npos)
      << report.sensorFile();
}

TEST_F(SensorSurveyTest, FindsThatNeighbouringRaysErrAlike)
{
  for (int i = 0; i < 100; ++i)
  {
    Scan scan = scanAt({}, 0);
    double before = normal(0.01);
    for (double& range_m : scan.range_m)
    {
      const double now = normal(0.01);
      range_m += (now + before) / std::sqrt(2.0);  // the mean of two readings
      before = now;
    }
    survey_.add(scan);
  }
  const SensorReport report = survey_.report();
  EXPECT_NEAR(report.standing.raysPerReading, 2, 0.2);
  EXPECT_NEAR(report.standing.noise.sigmaAt_m(3), 0.01, 0.001);
}

TEST_F(SensorSurveyTest, FindsAnOffsetBetweenInterleavedHalfScans)
{
  for (int i = 0; i < 50; ++i)
  {
    Scan scan = scanAt({0.05 * i, 0, 0}, 0.005);
    for (std::size_t ray = 1; ray < scan.range_m.size(); ray += 2) scan.range_m[ray] += 0.008;
    survey_.add(scan);
  }
  const SensorReport report = survey_.report();
  EXPECT_NEAR(report.halfScans.oddMinusEven_m, 0.008, 0.0015);
  EXPECT_LT(report.halfScans.sigma_m, 0.001);
}

// Even rays are cast from one pose, odd ones 13 ms later from another.
TEST_F(SensorSurveyTest, FindsHowMuchLaterOddRaysAreCast)
{
  constexpr double kDelay_s = 0.013;
  for (int i = 0; i < 60; ++i)
  {
    const Pose2 pose{0.05 * i - 1, 0, 0.02 * i};
    const PlanarVelocity velocity{std::uniform_real_distribution<double>(0, 1)(rng_), 0,
                                  normal(0.5)};
    Scan scan = scanAt(pose, 0.005);
    const Pose2 moved{velocity.x_m_s * kDelay_s, 0, velocity.phi_rad_s * kDelay_s};
    const Scan odd = scanAt(pose * moved, 0.005);
    for (std::size_t ray = 1; ray < scan.range_m.size(); ray += 2)
      scan.range_m[ray] = odd.range_m[ray];
    survey_.compareTurns(scan, velocity);
  }
  const SensorReport report = survey_.report();
  EXPECT_EQ(report.oddRayDelay.scans, 60);
  EXPECT_NEAR(report.oddRayDelay.byDriving_s, kDelay_s, 0.001);
  EXPECT_NEAR(report.oddRayDelay.byTurning_s, kDelay_s, 0.001);
  EXPECT_LT(report.rawHalfScans.oddMinusEven_m, -0.002) << "half a metre a second, on walls ahead";
}

TEST_F(SensorSurveyTest, FindsNoDelayWhereAllRaysAreCastAtOnce)
{
  for (int i = 0; i < 60; ++i) survey_.compareTurns(scanAt({0.05 * i - 1, 0, 0}), {0.5, 0, 0.3});
  const SensorReport report = survey_.report();
  EXPECT_NEAR(report.oddRayDelay.byDriving_s, 0, 0.001);
  EXPECT_NEAR(report.oddRayDelay.byTurning_s, 0, 0.001);
}

TEST_F(SensorSurveyTest, OfADrivingScannerWallsAreTheEvidence)
{
  for (int i = 0; i < 100; ++i) survey_.add(scanAt({0.02 * i - 1, 0, 0}));
  const SensorReport report = survey_.report();
  EXPECT_EQ(report.standing.scans, 0);
  EXPECT_FALSE(report.wholeScan);
  EXPECT_EQ(&report.best(), &report.walls);
  EXPECT_EQ(report.sensorFile().find("whole_scan"), std::string::npos);
  EXPECT_NE(report.sensorFile().find("range_sigma_m = 0.01"), std::string::npos)
      << report.sensorFile();
}

TEST_F(SensorSurveyTest, BearsScansWithoutReturns)
{
  Scan blind = scanAt({});
  blind.range_m.assign(blind.range_m.size(), 0);
  for (int i = 0; i < 30; ++i) survey_.add(blind);
  survey_.add(Scan());
  const SensorReport report = survey_.report();
  EXPECT_EQ(report.walls.scans, 0);
  EXPECT_EQ(report.walls.noise.sigma_m, 0);
}
}  // namespace psmks
