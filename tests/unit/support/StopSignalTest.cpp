/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/StopSignal.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

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
  raise(SIGTERM);
  EXPECT_EQ(stopSignal(), SIGTERM) << "sent twice by timeout(1), it is the same wish";
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_DEATH(raise(SIGTERM), "") << "later it ends the program";
}

TEST(StopSignal, HasAName)
{
  EXPECT_STREQ(nameOfSignal(SIGINT), "SIGINT");
  EXPECT_STREQ(nameOfSignal(SIGTERM), "SIGTERM");
  EXPECT_STREQ(nameOfSignal(SIGHUP), "SIGHUP");
}
}  // namespace psmks
