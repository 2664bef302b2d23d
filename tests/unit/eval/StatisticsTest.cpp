/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Statistics.h>

#include <cmath>

namespace psmks
{
TEST(Statistics, MedianOfAnOddCountIsTheMiddleValue) { EXPECT_DOUBLE_EQ(median({9, 1, 4}), 4); }

TEST(Statistics, MedianOfAnEvenCountLiesBetweenTheMiddleValues)
{
  EXPECT_DOUBLE_EQ(median({8, 1, 2, 4}), 3);
}

// values   0   10   20   30   40
// p        0  .25   .5  .75    1
TEST(Statistics, QuantileInterpolatesBetweenNeighbours)
{
  const std::vector<double> values{30, 0, 40, 10, 20};
  EXPECT_DOUBLE_EQ(quantile(values, 0), 0);
  EXPECT_DOUBLE_EQ(quantile(values, 0.95), 38);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 40);
}

TEST(Statistics, NoValuesHaveNoStatistics)
{
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_TRUE(std::isnan(mean({})));
}

TEST(Statistics, MeanIsTheSumByTheCount) { EXPECT_DOUBLE_EQ(mean({1, 2, 6}), 3); }
}  // namespace psmks
