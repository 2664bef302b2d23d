/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/NoReturnReading.h>

#include <cmath>

namespace psmks
{
namespace
{
NoReturnReading readings(double nearest_m, double farthest_m, double step_m)
{
  NoReturnReading reading;
  for (double range_m = nearest_m; range_m < farthest_m; range_m += step_m) reading.add(range_m);
  return reading;
}

TEST(NoReturnReading, OfASickAreAllCodesBeyondItsRange)
{
  NoReturnReading reading = readings(1, 40, 0.01);
  reading.add(81.83);
  reading.add(81.91);
  EXPECT_EQ(reading.limit_m(), 80);
}

TEST(NoReturnReading, StandsOutAmongTheLargest)
{
  NoReturnReading reading = readings(1, 5.5, 0.01);
  for (int i = 0; i < 100; ++i) reading.add(5.6);
  EXPECT_EQ(reading.limit_m(), 5.6);
}

TEST(NoReturnReading, IsNotTheFarthestWall)
{
  NoReturnReading reading = readings(1, 7, 0.01);
  for (int i = 0; i < 20; ++i) reading.add(7);
  EXPECT_GT(reading.limit_m(), 7);
  EXPECT_GT(readings(1, 120, 0.1).limit_m(), 120);
}

TEST(NoReturnReading, IsNothingThatIsNoRange)
{
  NoReturnReading reading;
  for (int i = 0; i < 100; ++i)
    for (const double value : {std::nan(""), double(INFINITY), -1.0, 0.0}) reading.add(value);
  EXPECT_EQ(reading.limit_m(), 80);
}
}  // namespace
}  // namespace psmks
