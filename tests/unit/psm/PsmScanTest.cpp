/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/unit/psm/PsmScenes.h>

namespace psmks
{
namespace
{
using test::drawnScan;
using test::kNothing_m;
using test::prepared;
using test::unfiltered;

using Ranges = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Ranges filtered(const Scan& scan, int window)
{
  PsmOptions options;
  options.medianWindow = window;
  return prepared(scan, options).range_m;
}

TEST(PsmScan, ASingleWildReadingTakesTheMedianOfItsNeighbours)
{
  const Scan scan = drawnScan({2, 2.1, 2.2, 9, 2.4, 2.5, 2.6});
  EXPECT_EQ(filtered(scan, 3), (Ranges{2, 2.1, 2.2, 2.4, 2.5, 2.5, 2.6}));
  EXPECT_EQ(filtered(scan, 1), scan.range_m);
}

TEST(PsmScan, TheMedianLeavesARampAndMendsAHoleInIt)
{
  const Scan scan = drawnScan({1, 1.1, 1.2, kNan, 1.4, 1.5, 1.6});
  EXPECT_EQ(filtered(scan, 5), (Ranges{1, 1.1, 1.2, 1.4, 1.5, 1.6, 1.6}));
}

TEST(PsmScan, TheMedianGoesRoundAClosedScanAndRepeatsTheEndsOfAnOpenOne)
{
  const Ranges range_m{9, 2, 2, 2, 2, 2, 2, 3};
  EXPECT_EQ(filtered(drawnScan(range_m, 2 * kPi), 3).front(), 3);
  EXPECT_EQ(filtered(drawnScan(range_m, kPi), 3).front(), 9);
}

TEST(PsmScan, WhatIsNoReadingTakesNoPart)
{
  Scan scan = drawnScan({2, 0, -1, kNan, kNothing_m, 30, 31, 5});
  scan.valid.assign(8, 1);
  scan.valid[7] = 0;
  const PsmScan result = prepared(scan);
  EXPECT_EQ(result.goodRays(), 1);
  EXPECT_TRUE(result.isGood(0));
  for (int i = 1; i < 8; ++i) EXPECT_EQ(result.range(i), kNothing_m) << i;
}

TEST(PsmScan, TheOptionNarrowsTheMaximumRange)
{
  PsmOptions options = unfiltered();
  options.maxRange_m = 4;
  const PsmScan result = prepared(drawnScan({2, 3, 5}), options);
  EXPECT_EQ(result.goodRays(), 2);
  EXPECT_EQ(result.maxRange_m, 4);
}

TEST(PsmScan, RangesThatDoNotFitTheGridAreNone)
{
  Scan scan = drawnScan({2, 3, 5});
  scan.range_m.pop_back();
  EXPECT_EQ(prepared(scan).rays(), 3);
  EXPECT_EQ(prepared(scan).goodRays(), 0);
  EXPECT_EQ(prepared(Scan()).rays(), 0);
}
}  // namespace
}  // namespace psmks
