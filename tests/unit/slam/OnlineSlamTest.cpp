/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/OnlineSlam.h>
#include <psmks/slam/TrajectoryBuilder.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/** A robot that drives a curve through the office, 0.1 m and 3 degrees a step, one step a second.
 *  Its scanner sits 0.2 m ahead of its centre, turned to the left. Its wheels measure each step
 *  one centimetre too long:
 *
 *     +---------------------+
 *     |        []           |
 *     |   o--._             |
 *     |       `-.        /  |
 *     +---------------------+                                                             */
class OnlineSlamTest : public testing::Test
{
 protected:
  const BeamGrid grid_ = BeamGrid::centered(degToRad(270), 541);
  const Pose2 T_robot_sensor_{0.2, 0, degToRad(15)};
  const Pose2 T_office_start_{-0.5, -0.3, degToRad(20)};
  const Pose2 trueStep_{0.10, 0, degToRad(3)}, measuredStep_{0.11, 0, degToRad(3)};

  static Pose2 repeated(const Pose2& step, int times)
  {
    Pose2 T;
    for (int i = 0; i < times; ++i) T = T * step;
    return T;
  }

  /** Where the robot is at a scan, in the frame of the robot at the first scan. */
  Pose2 truth(int scan) const { return repeated(trueStep_, scan); }

  Scan scanAt(int scan) const
  {
    Scan seen = castScan(officeRoom(), T_office_start_ * truth(scan) * T_robot_sensor_, grid_);
    seen.stamp_s = scan;
    return seen;
  }

  Scan nothingAt(int scan) const
  {
    Scan seen = scanAt(scan);
    seen.range_m.assign(seen.range_m.size(), kNan);
    return seen;
  }

  OnlinePose add(const Scan& scan) { return slam_.addScan(scan, T_robot_sensor_); }

  OnlineSlam slam_;
};
}  // namespace

TEST_F(OnlineSlamTest, TheFirstScanIsTheOriginOfTheWorld)
{
  const OnlinePose pose = add(scanAt(0));
  EXPECT_EQ(pose.source, PoseSource::FirstScan);
  EXPECT_EQ(pose.match.status, MatchStatus::NotRun);
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, {}, 0, 0));
  EXPECT_TRUE(pose.T_world_robot.covariance.isZero());
}

TEST_F(OnlineSlamTest, TellsTheRobotsPoseAfterEveryScan)
{
  for (int i = 0; i < 10; ++i)
  {
    slam_.addOdometry(i, repeated(measuredStep_, i));
    const OnlinePose pose = add(scanAt(i));
    EXPECT_EQ(pose.stamp_s, i);
    EXPECT_TRUE(isNearly(pose.T_world_robot.pose, truth(i), 2e-3, degToRad(0.05))) << "scan " << i;
    if (i == 0) continue;
    EXPECT_EQ(pose.source, PoseSource::Match);
    EXPECT_EQ(pose.match.status, MatchStatus::Converged);
    EXPECT_GT(pose.T_world_robot.covariance.diagonal().minCoeff(), 0);
    EXPECT_LT(std::sqrt(pose.T_world_robot.covariance(0, 0)), 0.02);
  }
  EXPECT_EQ(slam_.scans().size(), 10u);
}

TEST_F(OnlineSlamTest, TakesIncrements)
{
  add(scanAt(0));
  const Pose2 half{0.055, 0, degToRad(1.5)};
  slam_.addMotion(half);
  slam_.addMotion(half);
  const OnlinePose pose = add(nothingAt(1));
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, half * half, 1e-12, 1e-12));
  EXPECT_EQ(pose.source, PoseSource::Odometry);
}

TEST_F(OnlineSlamTest, NeedsNoOdometry)
{
  for (int i = 0; i < 5; ++i)
  {
    const OnlinePose pose = add(scanAt(i));
    EXPECT_TRUE(isNearly(pose.T_world_robot.pose, truth(i), 2e-3, degToRad(0.05))) << "scan " << i;
  }
}

TEST_F(OnlineSlamTest, DrivesByOdometryWhereNothingMatches)
{
  slam_.addOdometry(0, {});
  add(scanAt(0));
  slam_.addOdometry(1, measuredStep_);
  const OnlinePose pose = add(nothingAt(1));
  EXPECT_EQ(pose.source, PoseSource::Odometry);
  EXPECT_EQ(pose.match.status, MatchStatus::InvalidInput);
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, measuredStep_, 1e-12, 1e-12));
  EXPECT_GE(pose.T_world_robot.covariance(0, 0), std::pow(OdometryOptions().minSigma_m, 2));

  const OnlinePose recovered = add(scanAt(2));
  EXPECT_EQ(recovered.source, PoseSource::Match);
  EXPECT_TRUE(isNearly(recovered.T_world_robot.pose, truth(2), 2e-3, degToRad(0.05)));
}

TEST_F(OnlineSlamTest, RepeatsTheMotionBeforeWhereNothingIsKnown)
{
  slam_.addMotion({});
  add(scanAt(0));
  slam_.addMotion(measuredStep_);
  const Pose2 T_world_matched = add(scanAt(1)).T_world_robot.pose;
  const OnlinePose pose = add(nothingAt(2));
  EXPECT_EQ(pose.source, PoseSource::ConstantVelocity);
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, T_world_matched * T_world_matched, 1e-9, 1e-9));
}

TEST_F(OnlineSlamTest, TakesAnythingWithoutAnException)
{
  Scan misfit = scanAt(2);
  misfit.range_m.resize(7);
  Scan timeless = scanAt(3);
  timeless.stamp_s = kNan;
  slam_.addOdometry(kNan, {kNan, 0, 0});
  slam_.addMotion({kNan, kNan, kNan});
  for (const Scan& scan : {Scan(), nothingAt(1), misfit, timeless, scanAt(4)})
  {
    const OnlinePose pose = add(scan);
    EXPECT_TRUE(pose.T_world_robot.pose.isFinite());
    EXPECT_TRUE(pose.T_world_robot.covariance.allFinite());
  }
}

TEST_F(OnlineSlamTest, TellsTheListenerWhatItReturns)
{
  std::vector<OnlinePose> heard;
  slam_.setListener([&heard](const OnlinePose& pose) { heard.push_back(pose); });
  add(scanAt(0));
  const OnlinePose returned = add(scanAt(1));
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[1].stamp_s, 1);
  EXPECT_TRUE(isNearly(heard[1].T_world_robot.pose, returned.T_world_robot.pose, 0, 0));
  EXPECT_EQ(heard[1].match.status, returned.match.status);

  slam_.setListener(nullptr);
  add(scanAt(2));
  EXPECT_EQ(heard.size(), 2u);
}

TEST_F(OnlineSlamTest, GivesWhatTheTrajectoryBuilderGives)
{
  TrajectoryBuilder builder(makePairMatcher("psmks"), ReferenceOptions(), OdometryOptions());
  for (int i = 0; i < 6; ++i)
  {
    const auto motion = i > 0 ? std::optional(measuredStep_) : std::nullopt;
    const UncertainPose expected = builder.add(scanAt(i), T_robot_sensor_, motion).T_world_robot;
    if (motion) slam_.addMotion(*motion);
    const UncertainPose pose = add(scanAt(i)).T_world_robot;
    EXPECT_TRUE(isNearly(pose.pose, expected.pose, 0, 0));
    EXPECT_EQ(pose.covariance, expected.covariance);
  }
}

TEST_F(OnlineSlamTest, GoesOnAfterTheMapWasOptimised)
{
  for (int i = 0; i < 3; ++i) add(scanAt(i));
  slam_.optimise();
  const OnlinePose pose = add(scanAt(3));
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, truth(3), 2e-3, degToRad(0.05)));
}

TEST(OnlineSlamOptions, AreObeyed)
{
  OnlineSlamOptions options;
  options.matcher.preprocessing.maxRange_m = 0.01;  // no wall is as near
  OnlineSlam slam(options);
  Scan scan;
  scan.grid = BeamGrid::centered(kPi, 181);
  scan.range_m.assign(181, 2);
  slam.addScan(scan);
  EXPECT_EQ(slam.addScan(scan).match.status, MatchStatus::InvalidInput);
}

TEST(PoseSource, HasAName)
{
  EXPECT_STREQ(toString(PoseSource::FirstScan), "FirstScan");
  EXPECT_STREQ(toString(PoseSource::Match), "Match");
  EXPECT_STREQ(toString(PoseSource::Odometry), "Odometry");
  EXPECT_STREQ(toString(PoseSource::ConstantVelocity), "ConstantVelocity");
}
}  // namespace psmks
