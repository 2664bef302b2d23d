/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/TrajectoryBuilder.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <map>

namespace psmks
{
namespace
{
/** Knows where each scan was taken (by its stamp), and fails for those it is told to: always, or
 * only against one reference. */
class Oracle : public PairMatcher
{
 public:
  static constexpr double kAlways = -1;

  std::map<double, Pose2> T_world_sensor;
  std::map<double, double> fails;  //!< stamp of the scan, of the reference

  std::string name() const override { return "oracle"; }
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    MatchResult result;
    const auto failure = fails.find(current.stamp_s);
    const bool failed = failure != fails.end() &&
                        (failure->second == kAlways || failure->second == reference.stamp_s);
    result.status = failed ? MatchStatus::NoImprovement : MatchStatus::Converged;
    result.T_ref_cur = failed ? guess.T_ref_cur
                              : T_world_sensor.at(reference.stamp_s).inverse() *
                                    T_world_sensor.at(current.stamp_s);
    result.covariance =
        failed ? *guess.covariance : Eigen::Matrix3d(1e-6 * Eigen::Matrix3d::Identity());
    result.score = 1;
    result.associations = 100;
    return result;
  }
};

/** A robot that drives 0.3 m a step and curves, with a scanner ahead and aside of its centre. */
class TrajectoryBuilderTest : public testing::Test
{
 protected:
  const Pose2 T_robot_sensor_{0.4, 0.2, degToRad(20)};
  const Pose2 trueStep_{0.3, 0, degToRad(5)}, measuredStep_{0.33, 0, degToRad(4)};

  Pose2 truth(int i) const
  {
    Pose2 T;
    for (int k = 0; k < i; ++k) T = T * trueStep_;
    return T;
  }

  /** Scans 0 to count - 1, with the stamps 0, 1, ... */
  std::vector<PosedScan> build(int count, const std::map<double, double>& fails,
                               const ReferenceOptions& options = {}, bool odometry = true) const
  {
    auto oracle = std::make_unique<Oracle>();
    for (int i = 0; i < count; ++i) oracle->T_world_sensor[i] = truth(i) * T_robot_sensor_;
    oracle->fails = fails;
    TrajectoryBuilder builder(std::move(oracle), options, OdometryOptions());
    for (int i = 0; i < count; ++i)
    {
      Scan scan;
      scan.stamp_s = i;
      builder.add(scan, T_robot_sensor_,
                  odometry && i > 0 ? std::optional(measuredStep_) : std::nullopt);
    }
    return builder.scans();
  }
};

TEST_F(TrajectoryBuilderTest, matchedScansStandWhereTheRobotStoodNotTheSensor)
{
  const auto scans = build(6, {});
  for (int i = 0; i < 6; ++i)
    EXPECT_TRUE(
        isNearly(scans[static_cast<std::size_t>(i)].T_world_robot.pose, truth(i), 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[3].T_last_robot.pose, trueStep_, 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[2].T_world_odometry, measuredStep_ * measuredStep_, 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, theReferenceIsReplacedAtTheTrigger)
{
  const auto scans = build(7, {});  // 0.3 m a step, trigger 0.8 m
  for (const std::size_t reference : {0u, 3u, 6u}) EXPECT_TRUE(scans[reference].isReference);
  for (const std::size_t other : {1u, 2u, 4u, 5u}) EXPECT_FALSE(scans[other].isReference);
  EXPECT_EQ(scans[3].matches.back().reference, 0u);
  EXPECT_EQ(scans[5].matches.back().reference, 3u);
}

TEST_F(TrajectoryBuilderTest, thePaperPosesTheScansBetweenTriggersByOdometry)
{
  ReferenceOptions paper;
  paper.matchEveryScan = false;
  const auto scans = build(4, {}, paper);
  EXPECT_TRUE(scans[1].matches.empty());
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, measuredStep_ * measuredStep_, 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, aFailedScanMovesByOdometryAndTheNextOneRecovers)
{
  const auto scans = build(4, {{2, Oracle::kAlways}});
  EXPECT_FALSE(scans[2].isMatched());
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, truth(1) * measuredStep_, 1e-9, 1e-9));
  EXPECT_GT(scans[2].T_world_robot.covariance(0, 0), 10 * scans[1].T_world_robot.covariance(0, 0));
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, aScanThatFailsAgainstTheReferenceIsMatchedAgainstTheScanBefore)
{
  const auto scans = build(4, {{2, 0}});
  ASSERT_EQ(scans[2].matches.size(), 2u);
  EXPECT_EQ(scans[2].matches[0].reference, 0u);
  EXPECT_EQ(scans[2].matches[1].reference, 1u);
  EXPECT_TRUE(scans[1].isReference);
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, truth(2), 1e-9, 1e-9));

  ReferenceOptions paper;
  paper.retryLastScan = false;
  EXPECT_EQ(build(4, {{2, 0}}, paper)[2].matches.size(), 1u);
}

TEST_F(TrajectoryBuilderTest, aReferenceThatFailsAgainAndAgainIsGivenUp)
{
  std::map<double, double> fails;
  for (int i = 1; i < 6; ++i) fails[i] = 0;
  const auto scans = build(7, fails);
  EXPECT_TRUE(scans[5].isReference);
  EXPECT_TRUE(scans[6].isMatched());
  EXPECT_EQ(scans[6].matches.back().reference, 5u);
}

TEST_F(TrajectoryBuilderTest, withoutOdometryTheLastMotionIsAssumedAgain)
{
  const auto scans = build(4, {{3, Oracle::kAlways}}, {}, false);
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
  EXPECT_GT(scans[3].T_world_robot.covariance(0, 0), 0.05);
}
}  // namespace
}  // namespace psmks
