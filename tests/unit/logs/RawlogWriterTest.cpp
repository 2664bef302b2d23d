/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CRawlog.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/mrpt/Convert.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Program.h>
#include <tests/support/Scenes.h>
#include <tests/support/ScratchFolder.h>

namespace psmks
{
namespace
{
constexpr double kStamp_s = 1e9, kPeriod_s = 0.1;
const Pose2 kMounting{0.2, -0.1, degToRad(30)};

struct Step
{
  Scan scan;
  Pose2 T_start_odometry;
};

/** A robot that turns on an arc through the office room, its scanner off centre and turned.
 *
 *     +------+---------+
 *     |      |  ___    |
 *     |  o-->_   \__\  |
 *     |       \        |
 *     +----------------+                                                                    */
std::vector<Step> drive(const BeamGrid& grid)
{
  std::vector<Step> steps;
  for (int i = 0; i < 4; ++i)
  {
    const Pose2 pose{0.1 * i, 0.02 * i, degToRad(6.0L * i)};
    Step step{castScan(officeRoom(), pose * kMounting, grid), pose};
    step.scan.stamp_s = kStamp_s + kPeriod_s * i;
    step.scan.rangeSigma_m = 0.02;
    step.scan.range_m[3] = 0;  // no return
    steps.push_back(step);
  }
  return steps;
}

class RawlogWriterTest : public testing::TestWithParam<RawlogFormat>
{
 protected:
  void write(const std::vector<Step>& steps) const
  {
    RawlogWriter::Options options;
    options.format = GetParam();
    options.T_robot_sensor = kMounting;
    RawlogWriter writer(options);
    ASSERT_TRUE(writer.open(path_));
    for (const auto& step : steps) writer.write(step.scan, step.T_start_odometry);
  }

  std::vector<LaserFrame> read() const
  {
    RawlogReader reader(path_);
    std::vector<LaserFrame> frames;
    for (LaserFrame frame; reader.next(frame);) frames.push_back(frame);
    EXPECT_EQ(reader.damage(), "");
    return frames;
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("drive.rawlog");
};

/** Wall points of a scan in the frame of the robot. */
std::vector<Eigen::Vector2d> points(const Scan& scan, const Pose2& T_robot_sensor)
{
  std::vector<Eigen::Vector2d> points_m;
  for (int ray = 0; ray < scan.grid.count(); ++ray)
    points_m.push_back(T_robot_sensor *
                       (scan.range_m[static_cast<std::size_t>(ray)] * scan.grid.direction(ray)));
  return points_m;
}

TEST_P(RawlogWriterTest, WhatTheReaderFindsIsWhatWasWritten)
{
  const auto steps = drive(BeamGrid::centered(kPi, 61));
  write(steps);
  const auto frames = read();
  ASSERT_EQ(frames.size(), steps.size());
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    EXPECT_NEAR(frames[i].stamp_s, steps[i].scan.stamp_s, 1e-6);
    EXPECT_EQ(frames[i].stamp_s, RawlogWriter::loggedStamp_s(steps[i].scan.stamp_s));
    const Scan scan = ScanConverter().convert(*frames[i].scan);
    ASSERT_EQ(scan.grid.count(), 61);
    EXPECT_NEAR(scan.rangeSigma_m, 0.02, 1e-6);
    EXPECT_NEAR(scan.maxRange_m, 30, 1e-6);
    for (std::size_t ray = 0; ray < 61; ++ray)
    {
      ASSERT_EQ(scan.valid[ray] != 0, ray != 3) << ray;
      if (ray == 3) continue;
      EXPECT_NEAR(scan.range_m[ray], steps[i].scan.range_m[ray], 1e-6);
    }
  }
}

TEST_P(RawlogWriterTest, TheWheelsMotionStandsBetweenTheScans)
{
  const auto steps = drive(BeamGrid::centered(kPi, 61));
  write(steps);
  const auto frames = read();
  ASSERT_EQ(frames.size(), steps.size());
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    ASSERT_TRUE(frames[i].odometry);
    EXPECT_TRUE(isNearly(*frames[i].odometry,
                         steps[i - 1].T_start_odometry.inverse() * steps[i].T_start_odometry, 1e-9,
                         1e-9));
  }
}

TEST_P(RawlogWriterTest, TheRaysPointWhereTheyDidWhateverTheGrid)
{
  for (const BeamGrid& grid : {BeamGrid::centered(kPi, 61), BeamGrid::centered(2 * kPi, 60),
                               BeamGrid(degToRad(-20), degToRad(1), 61)})
  {
    const auto steps = drive(grid);
    write(steps);
    const auto frames = read();
    ASSERT_EQ(frames.size(), steps.size());
    const Scan scan = ScanConverter().convert(*frames[0].scan);
    const auto mounting = sensorMounting(*frames[0].scan);
    EXPECT_EQ(scan.grid.closed(), grid.closed());
    const auto expected = points(steps[0].scan, kMounting);
    const auto found = points(scan, mounting.T_robot_sensor);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t ray = 4; ray < found.size(); ++ray)
      EXPECT_LT((found[ray] - expected[ray]).norm(), 1e-5) << ray;
  }
}

TEST_P(RawlogWriterTest, TheSameInputGivesTheSameBytes)
{
  const auto steps = drive(BeamGrid::centered(kPi, 61));
  write(steps);
  const std::string first = fileText(path_);
  write(steps);
  EXPECT_EQ(fileText(path_), first);
  EXPECT_GT(first.size(), 500u);
}

TEST_P(RawlogWriterTest, MrptReadsIt)
{
  write(drive(BeamGrid::centered(kPi, 61)));
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(path_));
  EXPECT_EQ(log.size(), 8u);
  using Entry = mrpt::obs::CRawlog::TEntryType;
  const bool actions = GetParam() == RawlogFormat::Actions;
  EXPECT_EQ(log.getType(0), actions ? Entry::etActionCollection : Entry::etObservation);
  EXPECT_EQ(log.getType(1), actions ? Entry::etSensoryFrame : Entry::etObservation);
}

TEST_P(RawlogWriterTest, AFolderThatIsMissingIsTold)
{
  EXPECT_FALSE(RawlogWriter({}).open("/no/such/folder/x.rawlog"));
}

INSTANTIATE_TEST_SUITE_P(Formats, RawlogWriterTest,
                         testing::Values(RawlogFormat::Actions, RawlogFormat::Observations),
                         [](const auto& format) {
                           return format.param == RawlogFormat::Actions ? "Actions"
                                                                        : "Observations";
                         });

TEST(RawlogActions, AreTrustedAsFarAsTheOptionsSay)
{
  RawlogWriter::Options options;
  const test::ScratchFolder folder;
  const std::string path = folder.path("drive.rawlog");
  const auto steps = drive(BeamGrid::centered(kPi, 61));
  {
    RawlogWriter writer(options);
    ASSERT_TRUE(writer.open(path));
    for (const auto& step : steps) writer.write(step.scan, step.T_start_odometry);
  }
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(path));
  const auto movement = log.getAsAction(2)->getBestMovementEstimation();
  ASSERT_TRUE(movement);
  const Pose2 motion = steps[0].T_start_odometry.inverse() * steps[1].T_start_odometry;
  const Eigen::Matrix3d expected = odometryCovariance(motion, options.odometry);
  const Eigen::Matrix3d stated = movement->poseChange->getCovariance().asEigen();
  for (int i = 0; i < 3; ++i)  // MRPT also applies the error of the angle to the path
    EXPECT_NEAR(stated(i, i), expected(i, i), 0.02 * expected(i, i)) << i;
}
}  // namespace
}  // namespace psmks
