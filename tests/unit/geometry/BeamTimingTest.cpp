/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/BeamTiming.h>

namespace psmks
{
namespace
{
/** A SICK LMS 200: 75 turns a second, a ray every degree in each of them. */
constexpr BeamTiming kLms{1.0 / 75, degToRad(1)};

Scan timed(const BeamGrid& grid, const BeamTiming& timing)
{
  Scan scan;
  scan.grid = grid;
  setTiming(timing, scan);
  return scan;
}

TEST(BeamTiming, TheSweepOfAHalfCircleTakesHalfATurn)
{
  EXPECT_NEAR(sweepDuration_s(BeamGrid::centered(kPi, 181), 0.04), 0.02, 1e-12);
  EXPECT_EQ(sweepDuration_s(BeamGrid(), 0.04), 0);
}

TEST(BeamTiming, AnUnknownTimeLeavesAScanUntimed)
{
  const Scan scan = timed(BeamGrid::centered(kPi, 361), {});
  EXPECT_EQ(scan.sweepDuration_s, 0);
  EXPECT_EQ(scan.interleavedTurns, 1);
  for (const int ray : {0, 1, 360}) EXPECT_EQ(sinceFirstRay_s(scan, ray), 0);
}

TEST(BeamTiming, TheDensityOfTheRaysTellsTheNumberOfTurns)
{
  EXPECT_EQ(timed(BeamGrid::centered(kPi, 181), kLms).interleavedTurns, 1);
  EXPECT_EQ(timed(BeamGrid::centered(kPi, 361), kLms).interleavedTurns, 2);
  EXPECT_EQ(timed(BeamGrid(-kPi / 2, degToRad(0.5), 360), kLms).interleavedTurns, 2);
  EXPECT_EQ(timed(BeamGrid::centered(degToRad(100), 401), kLms).interleavedTurns, 4);
  EXPECT_EQ(timed(BeamGrid::centered(kPi, 91), kLms).interleavedTurns, 1);
}

// Rays 0, 1, 2 at 0, 0.5 and 1 degree: ray 1 waits for the next turn, which takes 13.3 ms, and
// the beam passes a degree in 1/360 of it.
TEST(BeamTiming, OddRaysOfTwoTurnsComeOneTurnLater)
{
  const Scan scan = timed(BeamGrid::centered(kPi, 361), kLms);
  EXPECT_EQ(sinceFirstRay_s(scan, 0), 0);
  EXPECT_NEAR(sinceFirstRay_s(scan, 1), kLms.turn_s * (1 + 0.5 / 360), 1e-12);
  EXPECT_NEAR(sinceFirstRay_s(scan, 2), kLms.turn_s * 1.0 / 360, 1e-12);
  EXPECT_NEAR(sinceFirstRay_s(scan, 360), kLms.turn_s / 2, 1e-12);
  EXPECT_NEAR(turnOffset_s(scan, 2), -kLms.turn_s / 2, 1e-12);
  EXPECT_NEAR(turnOffset_s(scan, 3), kLms.turn_s / 2, 1e-12);
  EXPECT_NEAR(sinceMiddle_s(scan, 0), -sinceMiddle_s(scan, 359), kLms.turn_s / 360);
}

// Upside down the beam comes to the last ray first. Of 360 rays the last one is odd: odd ones
// belong to the first turn then.
TEST(BeamTiming, AgainstTheOrderOfTheRaysTheLastRayIsFirst)
{
  const Scan scan = timed(BeamGrid(-kPi / 2, degToRad(0.5), 360), {-1.0 / 75, degToRad(1)});
  const double sweep_s = kLms.turn_s * 179.5 / 360;
  EXPECT_NEAR(sinceFirstRay_s(scan, 359), -sweep_s - kLms.turn_s, 1e-12);
  EXPECT_NEAR(sinceFirstRay_s(scan, 358), -sweep_s * 358 / 359, 1e-12);
}
}  // namespace
}  // namespace psmks
