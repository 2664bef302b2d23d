/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/MotionBetweenScans.h>
#include <tests/support/PoseMatcher.h>

#include <limits>

namespace psmks
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Pose2 kStep{0.2, 0, degToRad(10)};

//  The robot drives straight on with 1 m/s:
//
//     reading    0 s   0.4 s   0.8 s
//     scan          0.2 s   0.6 s            0.4 m between both
TEST(MotionBetweenScans, IsInterpolatedBetweenReadings)
{
  MotionBetweenScans motion;
  motion.addReading(0, {0, 0, 0});
  motion.addReading(0.4, {0.4, 0, 0});
  EXPECT_FALSE(motion.untilScan(0.2)) << "no scan before the first one";
  motion.addReading(0.8, {0.8, 0, 0});
  const auto found = motion.untilScan(0.6);
  ASSERT_TRUE(found);
  EXPECT_TRUE(isNearly(*found, {0.4, 0, 0}, 1e-12, 1e-12));
}

TEST(MotionBetweenScans, IsSeenFromTheRobotNotFromTheOdometrysFrame)
{
  MotionBetweenScans motion;
  motion.addReading(0, {5, 5, kPi / 2});
  motion.untilScan(0);
  motion.addReading(1, {5, 6, kPi / 2});  // along the heading, which is the odometry's y axis
  EXPECT_TRUE(isNearly(motion.untilScan(1).value_or(Pose2()), {1, 0, 0}, 1e-12, 1e-12));
}

TEST(MotionBetweenScans, IsUnknownWhereTheLastReadingIsOld)
{
  MotionBetweenScans motion;
  motion.addReading(0, {});
  motion.untilScan(0);
  EXPECT_FALSE(motion.untilScan(10)) << "no reading near this scan";
  motion.addReading(10.1, {1, 0, 0});
  EXPECT_FALSE(motion.untilScan(10.1)) << "no reading near the scan before";
  motion.addReading(10.2, {1.1, 0, 0});
  EXPECT_TRUE(motion.untilScan(10.2));
}

TEST(MotionBetweenScans, ChainsIncrementsUntilTheNextScan)
{
  MotionBetweenScans motion;
  motion.addIncrement(kStep);
  motion.addIncrement(kStep);
  EXPECT_TRUE(isNearly(motion.untilScan(0).value_or(Pose2()), kStep * kStep, 1e-12, 1e-12));
  EXPECT_FALSE(motion.untilScan(0)) << "nothing came since";
  motion.addIncrement(kStep);
  EXPECT_TRUE(isNearly(motion.untilScan(0).value_or(Pose2()), kStep, 1e-12, 1e-12));
}

TEST(MotionBetweenScans, IgnoresReadingsWhereThereAreIncrements)
{
  MotionBetweenScans motion;
  motion.addReading(0, {});
  motion.addIncrement(kStep);
  motion.untilScan(0);
  motion.addReading(1, {9, 9, 0});
  EXPECT_FALSE(motion.untilScan(1));
}

TEST(MotionBetweenScans, IgnoresReadingsThatAreNotFinite)
{
  MotionBetweenScans motion;
  motion.addReading(0, {});
  motion.untilScan(0);
  motion.addReading(0.5, {kNan, 0, 0});
  motion.addReading(kNan, {7, 0, 0});
  motion.addReading(1, {1, 0, 0});
  EXPECT_TRUE(isNearly(motion.untilScan(1).value_or(Pose2()), {1, 0, 0}, 1e-12, 1e-12));
}

TEST(MotionBetweenScans, IsUnknownAfterAnIncrementThatIsNotFinite)
{
  MotionBetweenScans motion;
  motion.addIncrement(kStep);
  motion.addIncrement({0, kNan, 0});
  EXPECT_FALSE(motion.untilScan(0));
  motion.addIncrement(kStep);
  EXPECT_TRUE(motion.untilScan(0)) << "what went wrong before the last scan is over";
}
}  // namespace
}  // namespace psmks
