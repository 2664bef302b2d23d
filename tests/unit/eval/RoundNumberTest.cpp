/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/RoundNumber.h>

namespace psmks
{
TEST(RoundNumber, BeginsWithOneTwoOrFiveAndIsNotAbove)
{
  EXPECT_DOUBLE_EQ(roundNumber(0.7), 0.5);
  EXPECT_DOUBLE_EQ(roundNumber(0.019), 0.01);
  EXPECT_DOUBLE_EQ(roundNumber(1), 1);
  EXPECT_DOUBLE_EQ(roundNumber(3), 2);
  EXPECT_DOUBLE_EQ(roundNumber(500), 500);
}
}  // namespace psmks
