/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/SteadyMotion.h>

#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
OdometryOptions options()
{
  OdometryOptions o;
  o.minSigma_m = 0.01;
  o.minSigma_rad = 0.02;
  o.accelerationSigma_m_s2 = 2;
  o.accelerationSigma_rad_s2 = 4;
  o.unknownSigma_m = 0.3;
  o.unknownSigma_rad = 0.5;
  return o;
}

void expectMotion(const UncertainPose& motion, const Pose2& pose, double sigma_m, double sigma_rad)
{
  EXPECT_NEAR(motion.pose.x_m, pose.x_m, 1e-9);
  EXPECT_NEAR(motion.pose.y_m, pose.y_m, 1e-9);
  EXPECT_NEAR(motion.pose.phi_rad, pose.phi_rad, 1e-9);
  EXPECT_NEAR(std::sqrt(motion.covariance(0, 0)), sigma_m, 1e-9);
  EXPECT_NEAR(std::sqrt(motion.covariance(1, 1)), sigma_m, 1e-9);
  EXPECT_NEAR(std::sqrt(motion.covariance(2, 2)), sigma_rad, 1e-9);
}

constexpr double kSigma_m = 0.01 + 2 * 0.1 * 0.1, kSigma_rad = 0.02 + 4 * 0.1 * 0.1;
const Pose2 kStep{0.05, 0.01, 0.03};

/** Scans every 0.1 s, the last one at 1 s, of which each tells the same step. */
SteadyMotion driven()
{
  SteadyMotion motion(options());
  for (int scan = 0; scan <= 10; ++scan)
  {
    motion.untilScan(0.1 * scan);
    motion.learn(kStep);
  }
  return motion;
}
}  // namespace

TEST(SteadyMotion, NothingIsKnownOfTheFirstMotion)
{
  SteadyMotion motion(options());
  motion.untilScan(0);
  expectMotion(motion.untilScan(0.1), {}, 0.3, 0.5);
}

TEST(SteadyMotion, TheRobotGoesOnAsItDid)
{
  expectMotion(driven().untilScan(1.1), kStep, kSigma_m, kSigma_rad);
}

// A stamp that is 40 ms late does not make the step longer; a missing scan makes it twice as long.
TEST(SteadyMotion, MotionsLastWholePeriods)
{
  expectMotion(driven().untilScan(1.14), kStep, kSigma_m, kSigma_rad);
  expectMotion(driven().untilScan(1.2), {0.10, 0.02, 0.06}, 0.01 + 2 * 0.2 * 0.2,
               0.02 + 4 * 0.2 * 0.2);
}

TEST(SteadyMotion, AStepOverTwoPeriodsTellsTheSameSpeed)
{
  SteadyMotion motion = driven();
  motion.untilScan(1.2);
  motion.learn({0.10, 0.02, 0.06});
  expectMotion(motion.untilScan(1.3), kStep, kSigma_m, kSigma_rad);
}

// In 0.5 s accelerations change the way by more than is ever assumed.
TEST(SteadyMotion, AMotionIsNeverLessCertainThanAnUnknownOne)
{
  expectMotion(driven().untilScan(1.3), {0.15, 0.03, 0.09}, 0.01 + 2 * 0.09, 0.02 + 4 * 0.09);
  SteadyMotion slow(options());
  for (const double stamp_s : {0.0, 0.5, 1.0})
  {
    slow.untilScan(stamp_s);
    slow.learn(kStep);
  }
  expectMotion(slow.untilScan(1.5), kStep, 0.3, 0.5);
}

TEST(SteadyMotion, ARobotWhoseLastMotionWasNotMeasuredIsTakenToStand)
{
  SteadyMotion motion = driven();
  motion.untilScan(1.1);
  expectMotion(motion.untilScan(1.2), {}, 0.3, 0.5);
  motion.learn(kStep);
  expectMotion(motion.untilScan(1.3), kStep, kSigma_m, kSigma_rad);
}

TEST(SteadyMotion, AfterALongGapTheRobotIsTakenToStandAndTheMotionTellsNoSpeed)
{
  for (const double gap_s : {0.4, 60.0, 1e10})
  {
    SteadyMotion motion = driven();
    expectMotion(motion.untilScan(1 + gap_s), {}, 0.3, 0.5);
    motion.learn({5, 0, 0});
    expectMotion(motion.untilScan(1.1 + gap_s), {}, 0.3, 0.5);
  }
}

TEST(SteadyMotion, WithoutATimeTheLastMotionIsRepeated)
{
  for (const double stamp_s : {1.0, 0.5, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()})
    expectMotion(driven().untilScan(stamp_s), kStep, 0.3, 0.5);
}
}  // namespace psmks
