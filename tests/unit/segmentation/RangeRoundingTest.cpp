/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/Preprocessing.h>
#include <psmks/segmentation/RangeRounding.h>
#include <psmks/segmentation/Segmentation.h>
#include <tests/support/Scenes.h>

#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr double kStated_m = 0.01;

//   +-----------------+
//   |  s              |     walls from 1.5 to 12 m away
//   +-----------------+
Scan exactScan()
{
  const std::vector<Wall> hall = outline({{-1.5, -2}, {12, -2}, {12, 2}, {-1.5, 2}});
  Scan scan = castScan(hall, {}, BeamGrid::centered(2 * kPi, 720));
  scan.rangeSigma_m = 0;  // not stated
  return scan;
}

void addNoise(double sigma_m, unsigned seed, Scan& scan)
{
  std::mt19937 rng(seed);
  std::normal_distribution<double> noise(0, sigma_m);
  for (double& range_m : scan.range_m) range_m += noise(rng);
}

/** As a scanner with coarse units sends them. */
Scan roundedScan(double sigma_m, double step_m)
{
  Scan scan = exactScan();
  addNoise(sigma_m, 1, scan);
  for (double& range_m : scan.range_m) range_m = std::round(range_m / step_m) * step_m;
  return scan;
}

/** As from a simulator that marches along each ray until it stands behind the wall, and then adds
 * noise. */
Scan marchedScan(double step_m, double sigma_m, unsigned seed)
{
  Scan scan = exactScan();
  for (double& range_m : scan.range_m) range_m = std::ceil(range_m / step_m) * step_m;
  addNoise(sigma_m, seed, scan);
  return scan;
}

RangeRounding found(const Scan& raw, double stated_m = kStated_m)
{
  SegmentedScan scan;
  cleanScan(raw, {}, scan);
  scan.rangeNoise = {stated_m};
  RaySoA rays;
  rays.load(scan);
  return findRounding(rays);
}

SegmentedScan segmented(const Scan& scan)
{
  SegmentationBuffers buffers;
  SegmentedScan result;
  segmentScan(scan, {}, {}, buffers, result);
  return result;
}
}  // namespace

TEST(RangeRounding, IsFoundWhereRangesAreMultiples)
{
  EXPECT_NEAR(found(roundedScan(0.01, 0.05)).step_m, 0.05, 1e-9);
  EXPECT_EQ(found(roundedScan(0.01, 0.05)).overshoot_m, 0) << "nobody knows which way";
  EXPECT_EQ(found(roundedScan(0.01, 0.01)).step_m, 0) << "fine beside the noise";
  EXPECT_EQ(found(roundedScan(0.01, 0.05), 0.03).step_m, 0) << "fine beside the stated noise";
}

TEST(RangeRounding, IsFoundBeneathNoise)
{
  for (const double step_m : {0.08, 0.12, 0.16, 0.2})
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      const RangeRounding rounding = found(marchedScan(step_m, step_m / 12, seed));
      EXPECT_NEAR(rounding.step_m, step_m, 0.1 * step_m) << "seed " << seed;
      EXPECT_EQ(rounding.overshoot_m, rounding.step_m / 2) << "seed " << seed;
    }
}

TEST(RangeRounding, IsNoneWhereThereIsNoiseAlone)
{
  for (const double sigma_m : {0.0, 0.003, 0.01, 0.03, 0.1, 0.3})
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
      Scan scan = exactScan();
      addNoise(sigma_m, seed, scan);
      EXPECT_EQ(found(scan).step_m, 0) << sigma_m << " m, seed " << seed;
    }
}

TEST(RangeRounding, AddsTheVarianceOfAStep)
{
  const RangeRounding rounding{0.06, 0};
  EXPECT_NEAR(rounding.addedTo({0.01}).sigma_m, std::hypot(0.01, 0.06 / std::sqrt(12.0)), 1e-12);
  EXPECT_EQ(RangeRounding().addedTo({0.01}).sigma_m, 0.01);
}

//   +-- arcs ----------+    The side walls, drawn as some ten arcs each, are still walls, and where
//   |    s             |    they are: not behind, by half a step. A wall ahead may be one arc.
//   +-- arcs ----------+
TEST(RangeRounding, LeavesWallsWhereTheyAre)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    const SegmentedScan scan = segmented(marchedScan(0.16, 0.01, seed));
    int sides = 0;
    for (const Segment& segment : scan.segments)
    {
      if (segment.length_m() < 8) continue;
      ++sides;
      EXPECT_NEAR(std::abs(segment.line.phi0_rad), kPi / 2, degToRad(0.7)) << "seed " << seed;
      EXPECT_NEAR(segment.line.r0_m, 2, 0.04) << "seed " << seed;
    }
    EXPECT_EQ(sides, 2) << "seed " << seed;
    EXPECT_LE(scan.segments.size(), 8U) << "seed " << seed;
  }
}

TEST(RangeRounding, IsLeftAloneWhereTheScanStatesItsNoise)
{
  Scan raw = marchedScan(0.16, 0.01, 1);
  raw.rangeSigma_m = 0.05;
  EXPECT_EQ(segmented(raw).range_m, raw.range_m);
}
}  // namespace psmks
