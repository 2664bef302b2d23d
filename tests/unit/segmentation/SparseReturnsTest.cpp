/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/features/ScanFeatures.h>
#include <psmks/segmentation/Segmentation.h>
#include <tests/support/Scenes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace psmks
{
namespace
{
SegmentedScan segmented(const Scan& scan)
{
  SegmentationBuffers buffers;
  SegmentedScan result;
  segmentScan(scan, {}, {}, buffers, result);
  return result;
}

//   +----------+
//   |   [P]    |   the office room from its middle, by a scanner of half a degree that sees all
//   round
//   +----------+
Scan office(const Pose2& T_world_sensor, std::mt19937& random)
{
  return castScan(officeRoom(), T_world_sensor, BeamGrid::centered(2 * kPi, 720), 30, 0.01, random);
}

void loseAllBut(const std::function<bool(int)>& isKept, Scan& scan)
{
  for (int ray = 0; ray < scan.grid.count(); ++ray)
    if (!isKept(ray)) scan.range_m[static_cast<std::size_t>(ray)] = 0;
}
}  // namespace

TEST(SparseReturns, AScannerOfWhichEveryThirdRayReturnsIsOneWithThreeTimesTheIncrement)
{
  std::mt19937 random(1);
  Scan scan = office({}, random);
  loseAllBut([](int ray) { return ray % 3 == 1; }, scan);
  const SegmentedScan result = segmented(scan);
  ASSERT_EQ(result.rays(), 240);
  EXPECT_NEAR(result.grid.increment_rad(), 3 * scan.grid.increment_rad(), 1e-12);
  EXPECT_NEAR(result.grid.bearing_rad(0), scan.grid.bearing_rad(1), 1e-12);
  EXPECT_TRUE(result.grid.closed());
  EXPECT_EQ(result.validRays(), 240);
  EXPECT_EQ(result.range_m[10], scan.range_m[31]);
}

TEST(SparseReturns, SevenReturnsDoNotTellThatTheOthersNeverReturn)
{
  std::mt19937 random(1);
  Scan scan = office({}, random);
  loseAllBut([](int ray) { return ray % 2 == 0 && ray < 14; }, scan);
  EXPECT_EQ(segmented(scan).rays(), 720);
}

TEST(SparseReturns, ADenseScanHasNoHolesThatLeaveASurfaceWhole)
{
  std::mt19937 random(1);
  Scan scan = office({}, random);
  loseAllBut([](int ray) { return ray % 10 != 0; }, scan);
  EXPECT_EQ(segmented(scan).longestHole(), 0);
}

TEST(SparseReturns, TheWallsOfARoomAreFoundWhereTwoThirdsOfTheRaysAreLost)
{
  std::mt19937 random(2);
  std::bernoulli_distribution isKept(1.0 / 3);
  const Scan whole = office({}, random);
  Scan scan = whole;
  loseAllBut([&](int) { return isKept(random); }, scan);
  const SegmentedScan result = segmented(scan);
  EXPECT_GT(result.longestHole(), 3);
  EXPECT_GE(result.segments.size() + 2, segmented(whole).segments.size());
}

//   ----------      ----------    a wall with a gap of 2 m, of which half of the returns are lost:
//               [P]               the gap is no hole in it
TEST(SparseReturns, AGapThatIsLongerThanTheHolesEndsALine)
{
  const std::vector<Wall> walls{{{-6, 2}, {-1, 2}}, {{1, 2}, {6, 2}}};
  std::mt19937 random(4);
  std::bernoulli_distribution isKept(0.5);
  Scan scan = castScan(walls, {0, 0, kPi / 2}, BeamGrid::centered(kPi, 361), 30, 0.01, random);
  loseAllBut([&](int) { return isKept(random); }, scan);
  const SegmentedScan result = segmented(scan);
  ASSERT_GT(result.longestHole(), 3);
  for (const Segment& segment : result.segments)
    EXPECT_GT(segment.firstEnd_m.y() * segment.lastEnd_m.y(), 0) << "a line across the gap";
  EXPECT_EQ(result.segments.size(), 2U);
}

TEST(SparseReturns, AHoleInAWallIsPartOfItsSurface)
{
  std::mt19937 random(3);
  std::bernoulli_distribution isKept(0.5);
  Scan scan = office({}, random);
  loseAllBut([&](int) { return isKept(random); }, scan);
  const SegmentedScan result = segmented(scan);
  ScanFeatures features;
  features.build(result);
  ASSERT_FALSE(result.segments.empty());
  const Segment& wall = *std::max_element(result.segments.begin(), result.segments.end(),
                                          [](const Segment& a, const Segment& b)
                                          { return a.length_m() < b.length_m(); });
  int holes = 0;
  for (int ray = wall.firstRay; ray != wall.lastRay; ray = result.grid.neighbour(ray, 1))
  {
    holes += !result.isValid(ray);
    EXPECT_TRUE(features.surface.known(ray)) << "ray " << ray;
    EXPECT_FALSE(features.movable[static_cast<std::size_t>(ray)]) << "ray " << ray;
  }
  EXPECT_GT(holes, 10);
}

TEST(SparseReturns, ScansWithHalfOfTheirRaysMatch)
{
  const Matcher matcher;
  MatcherWorkspace workspace;
  const Pose2 T_ref_cur{0.3, -0.2, degToRad(10)};
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::bernoulli_distribution isKept(0.5);
    Scan reference = office({}, random), current = office(T_ref_cur, random);
    loseAllBut([&](int) { return isKept(random); }, reference);
    loseAllBut([&](int) { return isKept(random); }, current);
    const MatchResult result = matcher.match(reference, current, {}, workspace);
    EXPECT_TRUE(result.usable()) << "seed " << seed << ": " << result.report();
    const Pose2 error = T_ref_cur.inverse() * result.T_ref_cur;
    EXPECT_LT(error.translation().norm(), 0.02) << "seed " << seed;
    EXPECT_LT(std::abs(error.phi_rad), degToRad(0.3)) << "seed " << seed;
  }
}
}  // namespace psmks
