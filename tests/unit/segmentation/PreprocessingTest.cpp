/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/Preprocessing.h>

#include <limits>

namespace psmks
{
namespace
{
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Scan scanOf(const std::vector<double>& range_m)
{
  Scan scan;
  scan.grid = BeamGrid::centered(kPi / 2, static_cast<int>(range_m.size()));
  scan.range_m = range_m;
  scan.maxRange_m = 10;
  return scan;
}

SegmentedScan cleaned(const Scan& scan, const PreprocessingOptions& options = {})
{
  SegmentedScan result;
  cleanScan(scan, options, result);
  return result;
}

using Flags = std::vector<std::uint8_t>;
using Ranges = std::vector<double>;
}  // namespace

TEST(Preprocessing, OnlyFinitePositiveRangesBelowTheMaximumAreValid)
{
  const SegmentedScan result =
      cleaned(scanOf({2, kNan, kInf, -kInf, 0, -1, 10, 10.5, 9.999, 1e-3}));
  EXPECT_EQ(result.valid, (Flags{1, 0, 0, 0, 0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(result.range_m, (Ranges{2, 0, 0, 0, 0, 0, 0, 0, 9.999, 1e-3}));
}

TEST(Preprocessing, AbsurdRangesAreInvalidWithoutAMaximumToo)
{
  Scan scan = scanOf({2, kInf, 1e5, 1e300, 1e-300});
  scan.maxRange_m = 0;
  EXPECT_EQ(cleaned(scan).valid, (Flags{1, 0, 1, 0, 0}));
}

TEST(Preprocessing, FlaggedRaysAreInvalid)
{
  Scan scan = scanOf({2, 3, 4});
  scan.valid = {1, 0, 1};
  EXPECT_EQ(cleaned(scan).valid, (Flags{1, 0, 1}));
  EXPECT_EQ(cleaned(scan).range_m[1], 0);
}

//  \ : | : /     only every second ray returns: it is a scan of half as many rays
TEST(Preprocessing, RaysThatNeverReturnBetweenThoseThatDoAreTakenOut)
{
  const Scan scan = scanOf({0, 2, 0, 3, 0, 0, 0, 5, 0, 6, 0, 7, 0, 8, 0, 9, 0, 9.5, 0});
  const SegmentedScan result = cleaned(scan);
  EXPECT_EQ(result.range_m, (Ranges{2, 3, 0, 5, 6, 7, 8, 9, 9.5}));
  EXPECT_EQ(result.valid, (Flags{1, 1, 0, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(result.segmentOfRay.size(), 9U);
  ASSERT_EQ(result.rays(), 9);
  for (int ray = 0; ray < 9; ++ray)
    EXPECT_NEAR(result.grid.bearing_rad(ray), scan.grid.bearing_rad(2 * ray + 1), 1e-12) << ray;
}

TEST(Preprocessing, OneReturnBesideThemLeavesAllRaysInPlace)
{
  const std::vector<double> ranges{0, 2, 0, 3, 0, 4, 4.1, 5, 0, 6, 0, 7, 0, 8, 0, 9, 0};
  EXPECT_EQ(cleaned(scanOf(ranges)).range_m, ranges);
}

// Seven returns may be so far apart by chance.
TEST(Preprocessing, FewReturnsDoNotTellThatTheOthersNeverCome)
{
  const std::vector<double> seven{2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0};
  EXPECT_EQ(cleaned(scanOf(seven)).range_m, seven);
}

TEST(Preprocessing, AClosedScanStaysClosed)
{
  std::vector<double> everyThird;
  for (int k = 0; k < 10; ++k)
    for (const double range_m : {2.0, 0.0, 0.0}) everyThird.push_back(range_m);
  Scan scan = scanOf(everyThird);
  scan.grid = BeamGrid::centered(2 * kPi, 30);
  const SegmentedScan thinned = cleaned(scan);
  EXPECT_EQ(thinned.range_m, (Ranges(10, 2.0)));
  EXPECT_TRUE(thinned.grid.closed());

  scan.range_m.pop_back();
  scan.grid = BeamGrid::centered(2 * kPi, 29);
  EXPECT_EQ(cleaned(scan).rays(), 29) << "no multiple of 3: across the seam two are beside";
}

// Every 7th of 359 rays of a degree returns: 52 of them at 7 degrees would exceed the circle.
TEST(Preprocessing, AnOpenScanThatIsNearlyClosedKeepsItsRaysWhereFewerFitNoGrid)
{
  Scan scan = scanOf(std::vector<double>(359, 0));
  scan.grid = BeamGrid(-degToRad(179), degToRad(1), 359);
  for (std::size_t ray = 1; ray < 359; ray += 7) scan.range_m[ray] = 2;
  EXPECT_EQ(cleaned(scan).rays(), 359);
}

TEST(Preprocessing, AScanHasReturnsWhereARayIsValid)
{
  EXPECT_TRUE(hasReturns(scanOf({0, kNan, 3})));
  EXPECT_FALSE(hasReturns(scanOf({0, kNan, 11})));
  EXPECT_FALSE(hasReturns(Scan()));
}

TEST(Preprocessing, TheLimitOfTheRangeIsTheScansOrTheOptions)
{
  Scan scan = scanOf({1, 2});
  PreprocessingOptions options;
  EXPECT_EQ(cleaned(scan, options).maxRange_m, 10);
  options.maxRange_m = 5;
  EXPECT_EQ(cleaned(scan, options).maxRange_m, 5);
}

TEST(Preprocessing, TheOptionsNarrowTheRange)
{
  PreprocessingOptions options;
  options.minRange_m = 0.5;
  options.maxRange_m = 4;
  EXPECT_EQ(cleaned(scanOf({0.5, 0.6, 3.9, 4, 9}), options).valid, (Flags{0, 1, 1, 0, 0}));
  options.maxRange_m = 40;  // the scan's own limit of 10 m stands
  EXPECT_EQ(cleaned(scanOf({9, 11}), options).valid, (Flags{1, 0}));
}

TEST(Preprocessing, RangesThatDoNotFitTheGridLeaveNoValidRay)
{
  Scan scan = scanOf({2, 3, 4});
  scan.range_m.pop_back();
  const SegmentedScan result = cleaned(scan);
  EXPECT_EQ(result.rays(), 3);
  EXPECT_EQ(result.validRays(), 0);
  EXPECT_EQ(result.range_m, (Ranges{0, 0, 0}));
}

TEST(Preprocessing, WhatTheResultHeldBeforeIsGone)
{
  SegmentedScan result = cleaned(scanOf({2, 3, 4}));
  result.segments.resize(2);
  result.segmentOfRay = {0, 1, 1};
  cleanScan(scanOf({5, 6}), {}, result);
  EXPECT_TRUE(result.segments.empty());
  EXPECT_EQ(result.segmentOfRay, (std::vector<int>(2, SegmentedScan::kNoSegment)));
}

// A spike and a step, window 3:    2 2 7 2 2 5 5 5  ->  2 2 2 2 2 5 5 5
TEST(Preprocessing, TheMedianRemovesASpikeAndKeepsAStep)
{
  SegmentedScan scan = cleaned(scanOf({2, 2, 7, 2, 2, 5, 5, 5}));
  std::vector<double> scratch;
  medianFilter(3, scratch, scan);
  EXPECT_EQ(scan.range_m, (Ranges{2, 2, 2, 2, 2, 5, 5, 5}));
}

TEST(Preprocessing, TheMedianPassesOverInvalidRays)
{
  SegmentedScan scan = cleaned(scanOf({2, 0, 3, 0, 4}));
  std::vector<double> scratch;
  medianFilter(5, scratch, scan);
  EXPECT_EQ(scan.valid, (Flags{1, 0, 1, 0, 1}));
  EXPECT_EQ(scan.range_m[2], 3);
  EXPECT_EQ(scan.range_m[1], 0);
}

TEST(Preprocessing, TheMedianReachesAcrossTheSeamOfAClosedScan)
{
  Scan scan = scanOf({9, 2, 2, 2, 2, 2});
  scan.grid = BeamGrid::centered(2 * kPi, 6);
  SegmentedScan result = cleaned(scan);
  std::vector<double> scratch;
  medianFilter(3, scratch, result);
  EXPECT_EQ(result.range_m[0], 2);
}

TEST(Preprocessing, AMedianOfOneRayChangesNothing)
{
  for (const int window : {0, 1})
  {
    SegmentedScan scan = cleaned(scanOf({2, 7, 3}));
    std::vector<double> scratch;
    medianFilter(window, scratch, scan);
    EXPECT_EQ(scan.range_m, (Ranges{2, 7, 3}));
  }
}
}  // namespace psmks
