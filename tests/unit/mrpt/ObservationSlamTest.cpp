/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/system/datetime.h>
#include <psmks/mrpt/ObservationSlam.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/mrpt/Observation.h>

#include <limits>

namespace psmks::test
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
constexpr double kStart_s = 1.6e9;  // a time on the clock of the computer

/** A robot that drives a curve through the office, 0.1 m and 3 degrees from scan to scan.
 *  Its scanner sits ahead of its centre, upside down; its wheels measure one centimetre too much.
 */
class ObservationSlamTest : public testing::Test
{
 protected:
  const CPose2D T_office_start_{-0.5, -0.3, degToRad(20)};
  const CPose2D trueStep_{0.10, 0, degToRad(3)}, measuredStep_{0.11, 0, degToRad(3)};

  static CPose2D repeated(const CPose2D& step, int times)
  {
    CPose2D T;
    for (int i = 0; i < times; ++i) T = T + step;
    return T;
  }

  static double stamp_s(int scan) { return kStart_s + 0.5 * scan; }

  Pose2 truth(int scan) const { return toPose2(repeated(trueStep_, scan)); }

  CObservation2DRangeScan scanAt(int i) const
  {
    const Scanner scanner{CPose3D(0.2, 0, 0.3, degToRad(15), 0, kPi), true, degToRad(270), 541};
    CObservation2DRangeScan scan =
        observe(officeRoom(), T_office_start_ + repeated(trueStep_, i), scanner);
    scan.timestamp = mrpt::Clock::fromDouble(stamp_s(i));
    return scan;
  }

  CObservationOdometry odometryAt(int i) const
  {
    CObservationOdometry odometry;
    odometry.odometry = repeated(measuredStep_, i);
    odometry.timestamp = mrpt::Clock::fromDouble(stamp_s(i));
    return odometry;
  }

  /** The scan as one in which no ray met anything. */
  CObservation2DRangeScan nothingAt(int i) const
  {
    CObservation2DRangeScan scan = scanAt(i);
    for (std::size_t ray = 0; ray < scan.getScanSize(); ++ray)
      scan.setScanRangeValidity(ray, false);
    return scan;
  }

  ObservationSlam slam_;
};
}  // namespace

TEST_F(ObservationSlamTest, TellsTheRobotsPoseAfterEveryScan)
{
  for (int i = 0; i < 6; ++i)
  {
    slam_.addOdometry(odometryAt(i));
    const OnlinePose pose = slam_.addScan(scanAt(i));
    EXPECT_NEAR(pose.stamp_s, stamp_s(i), 1e-6);
    EXPECT_EQ(pose.source, i == 0 ? PoseSource::FirstScan : PoseSource::Match);
    EXPECT_TRUE(isNearly(pose.T_world_robot.pose, truth(i), 2e-3, degToRad(0.05))) << "scan " << i;
  }
  EXPECT_EQ(slam_.scans().size(), 6u);
}

TEST_F(ObservationSlamTest, GivesThePoseAsMrptsGaussian)
{
  slam_.addScan(scanAt(0));
  const OnlinePose pose = slam_.addScan(scanAt(1));
  const mrpt::poses::CPosePDFGaussian gaussian = toMrpt(pose.T_world_robot);
  EXPECT_TRUE(isNearly(toPose2(gaussian.mean), truth(1), 2e-3, degToRad(0.05)));
  EXPECT_EQ(gaussian.cov(0, 0), pose.T_world_robot.covariance(0, 0));
}

TEST_F(ObservationSlamTest, NeedsNoOdometry)
{
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(
        isNearly(slam_.addScan(scanAt(i)).T_world_robot.pose, truth(i), 2e-3, degToRad(0.05)));
}

TEST_F(ObservationSlamTest, DrivesByReadingsWhereNothingMatches)
{
  slam_.addOdometry(odometryAt(0));
  slam_.addScan(scanAt(0));
  slam_.addOdometry(odometryAt(1));
  const OnlinePose pose = slam_.addScan(nothingAt(1));
  EXPECT_EQ(pose.source, PoseSource::Odometry);
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, toPose2(measuredStep_), 1e-9, 1e-9));
}

TEST_F(ObservationSlamTest, DrivesByIncrementsWhereNothingMatches)
{
  slam_.addScan(scanAt(0));
  slam_.addMotion(measuredStep_);
  const OnlinePose pose = slam_.addScan(nothingAt(1));
  EXPECT_EQ(pose.source, PoseSource::Odometry);
  EXPECT_TRUE(isNearly(pose.T_world_robot.pose, toPose2(measuredStep_), 1e-9, 1e-9));
}

TEST_F(ObservationSlamTest, TakesOdometryWithoutATimeAsOfTheLastScan)
{
  CObservationOdometry timeless = odometryAt(0);
  timeless.timestamp = INVALID_TIMESTAMP;
  slam_.addScan(scanAt(0));
  slam_.addOdometry(timeless);
  slam_.addScan(scanAt(1));
  timeless.odometry = measuredStep_;
  slam_.addOdometry(timeless);
  const OnlinePose pose = slam_.addScan(nothingAt(2));
  EXPECT_EQ(pose.source, PoseSource::Odometry);
}

TEST_F(ObservationSlamTest, TakesATiltedScanAsOneWithoutAReturn)
{
  CObservation2DRangeScan tilted = scanAt(1);
  tilted.sensorPose = CPose3D(0.2, 0, 0.3, 0, degToRad(20), 0);
  slam_.addScan(scanAt(0));
  const OnlinePose pose = slam_.addScan(tilted);
  EXPECT_EQ(pose.source, PoseSource::ConstantVelocity);
  EXPECT_EQ(pose.match.status, MatchStatus::InvalidInput);
}

TEST_F(ObservationSlamTest, TakesAnObservationWithoutRays)
{
  slam_.addScan(scanAt(0));
  EXPECT_EQ(slam_.addScan(CObservation2DRangeScan()).match.status, MatchStatus::InvalidInput);
}

TEST_F(ObservationSlamTest, TellsTheListener)
{
  int calls = 0;
  slam_.setListener([&calls](const OnlinePose&) { ++calls; });
  slam_.addScan(scanAt(0));
  slam_.addScan(scanAt(1));
  EXPECT_EQ(calls, 2);
}

TEST_F(ObservationSlamTest, ObeysItsOptions)
{
  ObservationSlamOptions options;
  options.matching.matcher.preprocessing.maxRange_m = 0.01;  // no wall is as near
  ObservationSlam slam(options);
  slam.addScan(scanAt(0));
  EXPECT_EQ(slam.addScan(scanAt(1)).match.status, MatchStatus::InvalidInput);
}
}  // namespace psmks::test
