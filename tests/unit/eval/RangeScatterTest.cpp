/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/RangeScatter.h>

#include <cmath>
#include <limits>
#include <random>

namespace psmks
{
namespace
{
/** Errors with this noise at ranges of 1 to 9 m. */
RangeScatter scatterOf(const RangeNoise& noise)
{
  std::mt19937 rng(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> range_m(1, 9);
  RangeScatter scatter;
  for (int i = 0; i < 40000; ++i)
  {
    const double r_m = range_m(rng);
    scatter.add(r_m, noise.sigmaAt_m(r_m) * normal(rng));
  }
  return scatter;
}
}  // namespace

TEST(RangeScatter, FindsAConstantNoise)
{
  const RangeNoise noise = scatterOf({0.01, 0}).noise();
  EXPECT_NEAR(noise.sigma_m, 0.01, 0.0005);
  EXPECT_LT(noise.sigmaPerMetre_m, 0.0005);
}

TEST(RangeScatter, FindsANoiseThatGrowsWithTheRange)
{
  const RangeNoise noise = scatterOf({0.004, 0.003}).noise();
  EXPECT_NEAR(noise.sigma_m, 0.004, 0.001);
  EXPECT_NEAR(noise.sigmaPerMetre_m, 0.003, 0.0002);
}

TEST(RangeScatter, HasABinForEachMetreWithEnoughErrors)
{
  RangeScatter scatter;
  for (int i = 0; i < 100; ++i) scatter.add(2.5, i < 50 ? 0.01 : -0.01);
  for (int i = 0; i < 99; ++i) scatter.add(4.5, 0.01);
  const auto bins = scatter.bins();
  ASSERT_EQ(bins.size(), 1U);
  EXPECT_NEAR(bins[0].range_m, 2.5, 1e-12);
  EXPECT_NEAR(bins[0].sigma_m, 0.01, 1e-12);
  EXPECT_EQ(bins[0].errors, 100);
}

TEST(RangeScatter, IsNotMovedByOutliersNorByWhatIsNoError)
{
  RangeScatter scatter = scatterOf({0.01, 0});
  for (int i = 0; i < 400; ++i) scatter.add(1 + i / 50.0, 5);
  scatter.add(3, std::nan(""));
  scatter.add(-1, 0.1);
  scatter.add(std::numeric_limits<double>::infinity(), 0.1);
  EXPECT_NEAR(scatter.noise().sigma_m, 0.01, 0.001);
}

TEST(RangeScatter, OfNothingIsNothing)
{
  EXPECT_TRUE(RangeScatter().bins().empty());
  EXPECT_EQ(RangeScatter().noise().sigma_m, 0);
}
}  // namespace psmks
