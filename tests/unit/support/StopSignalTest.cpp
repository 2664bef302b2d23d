/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/StopSignal.h>
#include <gtest/gtest.h>

#include <csignal>

namespace psmks
{
// In this order, for the first signal is kept for the rest of the process.
TEST(StopSignal, TheFirstOneIsToldAndEndsNothing)
{
  EXPECT_FALSE(isToStop());
  catchStopSignals();
  EXPECT_EQ(stopSignal(), 0);
  raise(SIGTERM);
  EXPECT_TRUE(isToStop());
  raise(SIGINT);
  EXPECT_EQ(stopSignal(), SIGTERM);
  EXPECT_DEATH(raise(SIGTERM), "") << "the same one again ends the program";
}

TEST(StopSignal, HasAName)
{
  EXPECT_STREQ(nameOfSignal(SIGINT), "SIGINT");
  EXPECT_STREQ(nameOfSignal(SIGTERM), "SIGTERM");
  EXPECT_STREQ(nameOfSignal(SIGHUP), "SIGHUP");
}
}  // namespace psmks
