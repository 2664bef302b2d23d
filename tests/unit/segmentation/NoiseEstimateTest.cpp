/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/NoiseEstimate.h>
#include <psmks/segmentation/Preprocessing.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
constexpr RangeNoise kStated{0.01};

//   +-----------------+
//   |  s              |     walls from 1.5 to 12 m away
//   +-----------------+
RaySoA rays(const RangeNoise& real, unsigned seed, const RangeNoise& stated = kStated)
{
  const std::vector<Wall> room = outline({{-1.5, -2}, {12, -2}, {12, 2}, {-1.5, 2}});
  std::mt19937 rng(seed);
  std::normal_distribution<double> unitNoise;
  Scan raw = castScan(room, {}, BeamGrid::centered(2 * kPi, 720));
  for (double& range_m : raw.range_m) range_m += real.sigmaAt_m(range_m) * unitNoise(rng);
  SegmentedScan scan;
  cleanScan(raw, {}, scan);
  scan.rangeNoise = stated;
  RaySoA rays;
  rays.load(scan);
  return rays;
}

RangeNoise shown(const RangeNoise& real, unsigned seed, const RangeNoise& stated = kStated)
{
  std::vector<double> scratch;
  return shownNoise(rays(real, seed, stated), scratch);
}
}  // namespace

TEST(NoiseEstimate, IsWhatIsStatedWhereTheScanShowsNoMore)
{
  for (const double real_m : {0.0, 0.003, 0.01, 0.011})
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
      EXPECT_EQ(shown({real_m}, seed).sigma_m, kStated.sigma_m) << real_m << " m, " << seed;
      EXPECT_FALSE(shown({real_m}, seed).grows()) << real_m << " m, " << seed;
    }
}

TEST(NoiseEstimate, IsRaisedForAllRangesWhereAllAreNoisy)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const RangeNoise noise = shown({0.03}, seed);
    EXPECT_FALSE(noise.grows()) << "seed " << seed;
    EXPECT_NEAR(noise.sigma_m, 0.03, 0.006) << "seed " << seed;
  }
}

TEST(NoiseEstimate, GrowsWhereFarRangesAreNoisier)
{
  const RangeNoise real{0.005, 0.01};
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const RangeNoise noise = shown(real, seed);
    EXPECT_TRUE(noise.grows()) << "seed " << seed;
    for (const double range_m : {2.0, 10.0})
      EXPECT_NEAR(noise.sigmaAt_m(range_m) / real.sigmaAt_m(range_m), 1, 0.4)
          << range_m << " m, seed " << seed;
  }
}

TEST(NoiseEstimate, KeepsTheGrowthThatIsStated)
{
  const RangeNoise stated{0.005, 0.01};
  const RangeNoise same = shown(stated, 1, stated), twice = shown(stated.scaledTo(0.01), 1, stated);
  EXPECT_EQ(same.sigma_m, stated.sigma_m);
  EXPECT_EQ(same.sigmaPerMetre_m, stated.sigmaPerMetre_m);
  EXPECT_NEAR(twice.sigma_m, 0.01, 0.002);
  EXPECT_DOUBLE_EQ(twice.growth_1_m2(), stated.growth_1_m2());
}

TEST(NoiseEstimate, HasABound)
{
  EXPECT_LE(shown({0.5}, 1).sigma_m, 0.08);
  EXPECT_LE(shown({0.01, 0.2}, 1).sigmaPerMetre_m, 0.03);
}
}  // namespace psmks
