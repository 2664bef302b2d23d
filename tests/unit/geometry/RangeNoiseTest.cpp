/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/RangeNoise.h>

namespace psmks
{
TEST(RangeNoise, AddsTheSquaresOfBothParts)
{
  const RangeNoise noise{0.03, 0.01};
  EXPECT_DOUBLE_EQ(noise.sigmaAt_m(0), 0.03);
  EXPECT_DOUBLE_EQ(noise.sigmaAt_m(4), 0.05);
  EXPECT_DOUBLE_EQ(noise.varianceAt_m2(4), 0.0025);
}

TEST(RangeNoise, IsTheSameEverywhereWhereItDoesNotGrow)
{
  const RangeNoise noise{0.03};
  EXPECT_FALSE(noise.grows());
  EXPECT_EQ(noise.sigmaAt_m(20), 0.03);
  EXPECT_EQ(noise.growth_1_m2(), 0);
  EXPECT_EQ(noise.weightAt(20), 1);
  EXPECT_EQ(RangeNoise{}.growth_1_m2(), 0);
}

TEST(RangeNoise, GrowthAndWeightAreThoseOfTheVariance)
{
  const RangeNoise noise{0.03, 0.01};
  EXPECT_NEAR(noise.varianceAt_m2(7), 0.0009 * (1 + noise.growth_1_m2() * 49), 1e-15);
  EXPECT_NEAR(noise.weightAt(7), 0.0009 / noise.varianceAt_m2(7), 1e-15);
}

TEST(RangeNoise, KeepsItsGrowthWhenScaled)
{
  const RangeNoise noise{0.03, 0.01}, twice = noise.scaledTo(0.06);
  EXPECT_DOUBLE_EQ(twice.sigmaAt_m(4), 2 * noise.sigmaAt_m(4));
  EXPECT_DOUBLE_EQ(twice.growth_1_m2(), noise.growth_1_m2());
}
}  // namespace psmks
