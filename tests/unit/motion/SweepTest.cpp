/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/Sweep.h>
#include <tests/support/Scenes.h>

#include <limits>
#include <utility>

namespace psmks
{
namespace
{
constexpr double kRate_rad_s = degToRad(90);
constexpr double kSweep_s = 0.02;

/** What a scanner at the origin reports that turns with `rate` while it sweeps: ray i is cast at
 * its bearing plus what was turned by then, and filed under its bearing. */
Scan sweptScan(const BeamGrid& grid, double rate_rad_s, double sweep_s)
{
  Scan scan;
  scan.grid = grid;
  scan.sweepDuration_s = sweep_s;
  for (int i = 0; i < grid.count(); ++i)
  {
    const double turned_rad = rate_rad_s * sweep_s * i / (grid.count() - 1);
    const BeamGrid ray(grid.bearing_rad(i) + turned_rad, 1, 1);
    scan.range_m.push_back(castScan(officeRoom(), {}, ray).range_m[0]);
  }
  return scan;
}

/** Largest distance of a range from what a scanner at rest measures at its bearing. */
double worstError_m(const Scan& scan)
{
  double worst_m = 0;
  const Scan still = castScan(officeRoom(), {}, scan.grid);
  for (std::size_t i = 0; i < scan.range_m.size(); ++i)
    worst_m = std::max(worst_m, std::abs(scan.range_m[i] - still.range_m[i]));
  return worst_m;
}
}  // namespace

TEST(Sweep, ATurningScannerSeesWhatAStillOneSeesElsewhere)
{
  for (const double rate_rad_s : {kRate_rad_s, -kRate_rad_s})
  {
    Scan scan = sweptScan(BeamGrid::centered(kPi, 181), rate_rad_s, kSweep_s);
    EXPECT_GT(worstError_m(scan), 0.05);
    straightenSweep(scan, rate_rad_s);
    EXPECT_LT(worstError_m(scan), 1e-9);
  }
}

TEST(Sweep, RaysBeyondOnceRoundAreDropped)
{
  Scan scan = sweptScan(BeamGrid::centered(2 * kPi, 360), kRate_rad_s, 0.2);  // 18 degrees more
  scan.valid.assign(360, 1);
  straightenSweep(scan, kRate_rad_s);
  EXPECT_LT(scan.grid.count(), 360);
  EXPECT_TRUE(scan.grid.closed());
  EXPECT_EQ(scan.range_m.size(), static_cast<std::size_t>(scan.grid.count()));
  EXPECT_EQ(scan.valid.size(), scan.range_m.size());
  EXPECT_LT(worstError_m(scan), 1e-9);
}

TEST(Sweep, WithoutADurationOrATurnNothingChanges)
{
  const BeamGrid grid = BeamGrid::centered(kPi, 181);
  Scan atOnce = sweptScan(grid, 0, 0), still = sweptScan(grid, 0, kSweep_s), lost = still;
  straightenSweep(atOnce, kRate_rad_s);
  straightenSweep(still, 0);
  straightenSweep(lost, std::numeric_limits<double>::quiet_NaN());
  for (const Scan& scan : {atOnce, still, lost}) EXPECT_TRUE(scan.grid == grid);
}

TEST(Sweep, OfAHalfCircleTakesHalfATurn)
{
  EXPECT_NEAR(sweepDuration_s(BeamGrid::centered(kPi, 181), 0.04), 0.02, 1e-12);
  EXPECT_EQ(sweepDuration_s(BeamGrid(), 0.04), 0);
}

TEST(TurnRate, IsThatOfTheLastFifthOfASecond)
{
  TurnRate rate;
  EXPECT_EQ(rate.rate_rad_s(), 0);
  for (int i = 0; i <= 10; ++i) rate.add(0.1 * i, i < 6 ? 0 : 0.05);
  EXPECT_NEAR(rate.rate_rad_s(), 0.5, 1e-9);
}

// Messages that waited together come with stamps milliseconds apart.
TEST(TurnRate, StampsThatJitterDoNotMakeASpin)
{
  TurnRate rate;
  for (int i = 0; i <= 20; ++i) rate.add(0.1 * i + (i % 2 ? 0.045 : 0), 0.02);
  EXPECT_NEAR(rate.rate_rad_s(), 0.2, 0.05);
}

TEST(TurnRate, RecoversFromWhatIsNotFinite)
{
  using Reading = std::pair<double, double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [stamp_s, turned_rad] : {Reading(nan, 0.02), Reading(0.5, nan)})
  {
    TurnRate rate;
    rate.add(0, 0);
    rate.add(0.4, 0.02);
    rate.add(stamp_s, turned_rad);
    EXPECT_EQ(rate.rate_rad_s(), 0);
    for (int i = 5; i <= 10; ++i) rate.add(0.1 * i, 0.02);
    EXPECT_NEAR(rate.rate_rad_s(), 0.2, 1e-9);
  }
}

TEST(TurnRate, IsZeroWhereStampsTellNothing)
{
  TurnRate same, back, gap;
  for (int i = 0; i < 5; ++i) same.add(7, 0.1);
  back.add(7, 0);
  back.add(6, 0.1);
  gap.add(7, 0);
  gap.add(17, 0.1);
  for (const TurnRate& rate : {same, back, gap}) EXPECT_EQ(rate.rate_rad_s(), 0);
}
}  // namespace psmks
