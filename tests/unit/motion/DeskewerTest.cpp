/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/motion/Deskewer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace psmks
{
namespace
{
constexpr double kTurn_s = 1.0 / 75;
constexpr BeamTiming kOneTurn{kTurn_s, 0}, kTwoTurns{kTurn_s, degToRad(1)};
const BeamGrid kHalfDegrees = BeamGrid::centered(kPi, 361);
const Eigen::Matrix3d kVague =
    Eigen::Vector3d(1, 1, degToRad(60)).cwiseAbs2().asDiagonal();  // (m/s)^2, (rad/s)^2

/** Range from a place in a room of 8 x 5 m along a bearing.
 *
 *      y = 3  +---------------+
 *             |      ^ x      |
 *             |   sensor      |   in the middle of the scan it is at the origin
 *      y = -2 +---------------+
 *          x = -3           x = 5
 *
 * With a pillar, a square of 0.6 m stands in front of the wall ahead, its face at x = 3. */
double roomRange_m(const Eigen::Vector2d& from_m, double bearing_rad, bool hasPillar)
{
  const double c = std::cos(bearing_rad), s = std::sin(bearing_rad);
  const double ahead_m = c > 0 ? (5 - from_m.x()) / c : c < 0 ? (-3 - from_m.x()) / c : 1e9;
  const double aside_m = s > 0 ? (3 - from_m.y()) / s : s < 0 ? (-2 - from_m.y()) / s : 1e9;
  const double toFace_m = c > 0 ? (3 - from_m.x()) / c : 1e9;
  if (hasPillar && std::abs(from_m.y() + toFace_m * s) < 0.3) return toFace_m;
  return std::min(ahead_m, aside_m);
}

struct Scene
{
  bool hasPillar = false;
  double sigma_m = 0;
};

/** A scan from a sensor that moves with a constant velocity, seen from the pose of the scan. */
Scan scanOf(const BeamGrid& grid, const BeamTiming& timing, const PlanarVelocity& velocity,
            const Scene& scene = {})
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise_m(0, 1);
  Scan scan;
  scan.grid = grid;
  setTiming(timing, scan);
  for (int ray = 0; ray < grid.count(); ++ray)
  {
    const bool isOneTurn = scan.interleavedTurns == 1;
    const double time_s = isOneTurn ? sinceFirstRay_s(scan, ray) : sinceMiddle_s(scan, ray);
    const Eigen::Vector2d from_m(time_s * velocity.x_m_s, time_s * velocity.y_m_s);
    scan.range_m.push_back(
        roomRange_m(from_m, grid.bearing_rad(ray) + time_s * velocity.phi_rad_s, scene.hasPillar) +
        scene.sigma_m * noise_m(random));
  }
  return scan;
}

/** Differences of the ranges from those that a sensor at rest sees on the same bearings. NaN is
 * left out. */
std::vector<double> errors_m(const Scan& scan, bool hasPillar = false)
{
  std::vector<double> errors;
  for (int ray = 0; ray < scan.grid.count(); ++ray)
  {
    const double range_m = scan.range_m[static_cast<std::size_t>(ray)];
    const double error_m =
        std::abs(range_m - roomRange_m({0, 0}, scan.grid.bearing_rad(ray), hasPillar));
    if (!std::isnan(error_m)) errors.push_back(error_m);
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

double quantileOf(const std::vector<double>& sorted, double share)
{
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

Scan deskewed(Scan scan, const PlanarVelocity& velocity)
{
  Deskewer().deskew(scan, velocity);
  return scan;
}

void expectUnchanged(const Scan& scan, const PlanarVelocity& velocity)
{
  const Scan after = deskewed(scan, velocity);
  EXPECT_TRUE(after.grid == scan.grid);
  EXPECT_EQ(after.range_m, scan.range_m);
  EXPECT_EQ(after.valid, scan.valid);
}

TEST(Deskewer, TurningInOneTurnWidensTheGridAndChangesNoRange)
{
  for (const double rate_rad_s : {1.0, -1.0})
  {
    const PlanarVelocity velocity{0, 0, rate_rad_s};
    const Scan raw = scanOf(BeamGrid::centered(kPi, 181), kOneTurn, velocity);
    const Scan straight = deskewed(raw, velocity);
    EXPECT_EQ(straight.range_m, raw.range_m);
    EXPECT_NEAR(straight.grid.fieldOfView_rad(), kPi + rate_rad_s * kTurn_s / 2, 1e-9);
    EXPECT_GT(errors_m(raw).back(), 0.005);
    EXPECT_LT(errors_m(straight).back(), 1e-9);
  }
}

TEST(Deskewer, RaysBeyondOnceRoundAreDropped)
{
  constexpr double kRate_rad_s = 2;
  Scan scan = scanOf(BeamGrid::centered(2 * kPi, 360), {0.1, 0}, {0, 0, kRate_rad_s});
  scan.valid.assign(360, 1);
  scan = deskewed(scan, {0, 0, kRate_rad_s});
  const int kept = scan.grid.count();
  EXPECT_NEAR(kept * (1 + kRate_rad_s * 0.1 / (2 * kPi)), 360, 1.1);
  EXPECT_TRUE(scan.grid.closed());
  EXPECT_EQ(scan.range_m.size(), static_cast<std::size_t>(kept));
  EXPECT_EQ(scan.valid.size(), static_cast<std::size_t>(kept));
}

TEST(Deskewer, TranslationInOneTurnStays)
{
  expectUnchanged(scanOf(BeamGrid::centered(degToRad(240), 682), {0.1, 0}, {0.5, 0.1, 0}),
                  {0.5, 0.1, 0});
}

TEST(Deskewer, InterleavedTurnsBecomeOneScan)
{
  for (const double rate_deg_s : {-100.0, -40.0, 0.0, 20.0, 60.0})
  {
    const PlanarVelocity velocity{0.8, 0.1, degToRad(rate_deg_s)};
    const Scan raw = scanOf(kHalfDegrees, kTwoTurns, velocity);
    EXPECT_GT(quantileOf(errors_m(raw), 0.9), 0.005) << rate_deg_s;
    EXPECT_LT(quantileOf(errors_m(deskewed(raw, velocity)), 0.97), 0.001) << rate_deg_s;
  }
}

// Rays on the pillar and on the wall 2 m behind it: none ends in between, however fast the scanner
// turns.
TEST(Deskewer, EdgesStaySharp)
{
  for (const double rate_deg_s : {-50.0, -20.0, 20.0, 50.0})
  {
    const PlanarVelocity velocity{0, 0, degToRad(rate_deg_s)};
    const Scan straight = deskewed(scanOf(kHalfDegrees, kTwoTurns, velocity, {true, 0}), velocity);
    for (int ray = 150; ray < 210; ++ray)
    {
      const double x_m = straight.range_m[static_cast<std::size_t>(ray)] *
                         std::cos(straight.grid.bearing_rad(ray));
      EXPECT_LT(std::min(std::abs(x_m - 3), std::abs(x_m - 5)), 0.02) << ray;
    }
    const auto errors = errors_m(straight, true);
    EXPECT_LE(errors.end() - std::upper_bound(errors.begin(), errors.end(), 0.02), 4)
        << "one ray at either edge in either turn may be that of the other side";
  }
}

// The mean square of the noise is that of the raw ranges, so that no covariance is too small.
TEST(Deskewer, NoiseKeepsItsSize)
{
  constexpr double kSigma_m = 0.01;
  const PlanarVelocity velocity{0.5, 0, degToRad(37)};  // half a degree from turn to turn
  const Scan straight =
      deskewed(scanOf(kHalfDegrees, kTwoTurns, velocity, {false, kSigma_m}), velocity);
  double sum_m2 = 0;
  const std::vector<double> errors = errors_m(straight);
  for (const double error_m : errors) sum_m2 += error_m * error_m;
  EXPECT_NEAR(std::sqrt(sum_m2 / static_cast<double>(errors.size())), kSigma_m, 0.15 * kSigma_m);
}

TEST(Deskewer, ARayThatTheTurnDidNotReachIsNone)
{
  const PlanarVelocity velocity{0, 0, degToRad(150)};  // two degrees from turn to turn
  Scan scan = scanOf(kHalfDegrees, kTwoTurns, velocity);
  scan.valid.assign(scan.range_m.size(), 1);
  const Scan straight = deskewed(scan, velocity);
  EXPECT_TRUE(std::isnan(straight.range_m[1]));
  EXPECT_EQ(straight.valid[1], 0);
  EXPECT_EQ(straight.valid[0], 1);
  EXPECT_EQ(straight.valid[3], 1);
}

TEST(Deskewer, NoReturnsStayAndMoveWithTheirRays)
{
  const PlanarVelocity velocity{0, 0, degToRad(150)};  // one degree to either side
  Scan scan = scanOf(kHalfDegrees, kTwoTurns, velocity);
  scan.range_m[100] = 0;
  scan.range_m[201] = std::numeric_limits<double>::quiet_NaN();
  const Scan straight = deskewed(scan, velocity);
  EXPECT_FALSE(isReturn(straight, 98))
      << "of the first turn, when the scanner looked further right";
  EXPECT_FALSE(isReturn(straight, 203)) << "of the second turn, when it looked further left";
  EXPECT_TRUE(isReturn(straight, 100));
  EXPECT_TRUE(isReturn(straight, 201));
}

TEST(Deskewer, WhereNothingMovesOrNothingIsKnownNothingChanges)
{
  const PlanarVelocity velocity{1, 0.2, 1};
  const Scan moving = scanOf(kHalfDegrees, kTwoTurns, velocity);
  expectUnchanged(moving, {});
  expectUnchanged(moving, {0, 0, std::numeric_limits<double>::quiet_NaN()});
  expectUnchanged(scanOf(kHalfDegrees, {}, velocity), velocity);
  Scan damaged = moving;
  damaged.range_m.pop_back();
  expectUnchanged(damaged, velocity);
  expectUnchanged(Scan(), velocity);
}

TEST(Deskewer, TwoTurnsTellTheVelocityByThemselves)
{
  for (const PlanarVelocity& velocity :
       {PlanarVelocity{0.6, 0, 0}, PlanarVelocity{0.3, -0.2, 0.5}, PlanarVelocity{-0.5, 0, -0.9}})
  {
    const Scan scan = scanOf(kHalfDegrees, kTwoTurns, velocity, {true, 0.005});
    const PlanarVelocity fitted = Deskewer().fittedVelocity(scan, {}, kVague);
    // Three standard deviations, by 200 scans with this noise from all headings in this room.
    EXPECT_NEAR(fitted.x_m_s, velocity.x_m_s, 0.2);
    EXPECT_NEAR(fitted.y_m_s, velocity.y_m_s, 0.23);
    EXPECT_NEAR(fitted.phi_rad_s, velocity.phi_rad_s, degToRad(4.5));
  }
}

TEST(Deskewer, OneTurnTellsNoVelocity)
{
  const PlanarVelocity expected{0.1, 0.2, 0.3};
  const Scan scan = scanOf(kHalfDegrees, kOneTurn, {0.6, 0, 0});
  const PlanarVelocity fitted = Deskewer().fittedVelocity(scan, expected, kVague);
  EXPECT_EQ(fitted.x_m_s, expected.x_m_s);
  EXPECT_EQ(fitted.phi_rad_s, expected.phi_rad_s);
}

// A wall straight ahead tells the way towards it, not the way along it.
TEST(Deskewer, WhatTheTurnsDoNotTellStaysAsExpected)
{
  const PlanarVelocity velocity{0.6, 0, 0}, expected{0.1, 0.25, 0};
  const BeamGrid grid(degToRad(-15), degToRad(0.5), 61);
  const Scan scan = scanOf(grid, kTwoTurns, velocity, {false, 0.005});
  const PlanarVelocity fitted = Deskewer().fittedVelocity(
      scan, expected, Eigen::Vector3d(1, 0.3, degToRad(0.01)).cwiseAbs2().asDiagonal());
  EXPECT_NEAR(fitted.x_m_s, velocity.x_m_s, 0.1);
  EXPECT_NEAR(fitted.y_m_s, expected.y_m_s, 0.1);
}
}  // namespace
}  // namespace psmks
