/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/MountedScan.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/mrpt/Observation.h>

#include <algorithm>

namespace psmks::test
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;

namespace
{
constexpr double kPitch_rad = degToRad(4);
constexpr double kFloat_s = 1e-7;  // the aperture of an observation is a float

/** A half circle of rays in the office. */
CObservation2DRangeScan seenFrom(const CPose3D& sensorPose, bool rightToLeft = true)
{
  Scanner scanner;
  scanner.sensorPose = sensorPose;
  scanner.rightToLeft = rightToLeft;
  return observe(officeRoom(), {}, scanner);
}

MountedScan mounted(const CObservation2DRangeScan& observation,
                    const ScanMatcherOptions& options = {}, const BeamTiming& known = {})
{
  ScanConverter converter;
  return toMountedScan(observation, converter, options, known);
}

bool hasValidRay(const Scan& scan)
{
  return std::any_of(scan.valid.begin(), scan.valid.end(), [](auto flag) { return flag != 0; });
}
}  // namespace

TEST(MountedScan, HoldsTheScanAndThePlaceOfItsSensor)
{
  const CObservation2DRangeScan observation = seenFrom(CPose3D(0.3, 0.1, 0.5, 0.7, 0, 0));
  const MountedScan scan = mounted(observation);
  EXPECT_TRUE(isNearly(scan.T_robot_sensor, {0.3, 0.1, 0.7}, 1e-12, 1e-12));
  EXPECT_EQ(scan.scan.range_m, ScanConverter().convert(observation).range_m);
  EXPECT_TRUE(hasValidRay(scan.scan));
  EXPECT_EQ(scan.scan.sweepDuration_s, 0) << "unknown";
}

// A beam that goes round in 0.2 s sweeps a half circle in 0.1 s, in the order of the observation's
// rays: clockwise from above where the scanner hangs upside down or scans from left to right.
TEST(MountedScan, KnowsHowLongTheSweepTook)
{
  const CPose3D upright, upsideDown(0, 0, 0, 0, 0, kPi);
  ScanMatcherOptions options;
  options.beam.turn_s = 0.2;
  EXPECT_NEAR(mounted(seenFrom(upright), options).scan.sweepDuration_s, 0.1, kFloat_s);
  EXPECT_NEAR(mounted(seenFrom(upright, false), options).scan.sweepDuration_s, -0.1, kFloat_s);
  EXPECT_NEAR(mounted(seenFrom(upsideDown), options).scan.sweepDuration_s, -0.1, kFloat_s);
  EXPECT_NEAR(mounted(seenFrom(upsideDown, false), options).scan.sweepDuration_s, 0.1, kFloat_s);
}

TEST(MountedScan, PutsTheTimeOfTheOptionsBeforeThatFromElsewhere)
{
  ScanMatcherOptions options;
  EXPECT_NEAR(mounted(seenFrom({}), options, {0.4, 0}).scan.sweepDuration_s, 0.2, kFloat_s);
  options.beam.turn_s = 0.2;
  EXPECT_NEAR(mounted(seenFrom({}), options, {0.4, 0}).scan.sweepDuration_s, 0.1, kFloat_s);
}

// Half of the rays in each of two turns: every second ray is cast a turn later.
TEST(MountedScan, KnowsWhichRaysCameInAnotherTurn)
{
  const CObservation2DRangeScan observation = seenFrom({});
  ScanMatcherOptions options;
  options.beam.turn_s = 0.2;
  options.beam.turnIncrement_rad = 2 * ScanConverter().convert(observation).grid.increment_rad();
  const Scan scan = mounted(observation, options).scan;
  EXPECT_EQ(scan.interleavedTurns, 2);
  EXPECT_EQ(scan.turn_s, 0.2);
}

TEST(MountedScan, HasNoValidRayWhereItIsTiltedTooFar)
{
  const CObservation2DRangeScan tilted = seenFrom(CPose3D(0, 0, 0, 0, kPitch_rad, 0));
  ScanMatcherOptions options;
  options.maxTilt_rad = kPitch_rad + degToRad(0.1);
  EXPECT_TRUE(hasValidRay(mounted(tilted, options).scan));
  options.maxTilt_rad = kPitch_rad - degToRad(0.1);
  EXPECT_FALSE(hasValidRay(mounted(tilted, options).scan));
}

TEST(MountedScan, IsEmptyForAnObservationWithoutRays)
{
  EXPECT_EQ(mounted(CObservation2DRangeScan()).scan.grid.count(), 0);
}
}  // namespace psmks::test
