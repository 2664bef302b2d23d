/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#ifdef PSMKS_WITH_ROSBAG
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/RosBagReader.h>
#include <psmks/mrpt/Convert.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RosBag.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <limits>

namespace psmks
{
namespace
{
using test::RosBagWriter;
using test::says;

const std::vector<float> kRanges(181, 2.5f);
/** The pose of the robot at step k, which takes 0.1 s. */
Pose2 poseAt(int step) { return {0.1 * step, 0.05 * step, degToRad(3) * step}; }

class RosBagReaderTest : public testing::Test
{
 protected:
  /** Reads all frames of the bag. */
  std::vector<LaserFrame> frames(const RosBagOptions& options = RosBagOptions()) const
  {
    RosBagReader reader(path_, std::nullopt, options);
    std::vector<LaserFrame> frames;
    for (LaserFrame frame; reader.next(frame);) frames.push_back(frame);
    EXPECT_EQ(reader.damage(), "");
    return frames;
  }

  static void expectMotion(const std::vector<LaserFrame>& frames)
  {
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_FALSE(frames[0].odometry.has_value());
    for (int step = 1; step < 4; ++step)
    {
      const auto& odometry = frames[static_cast<std::size_t>(step)].odometry;
      ASSERT_TRUE(odometry.has_value());
      EXPECT_TRUE(isNearly(*odometry, poseAt(step - 1).inverse() * poseAt(step), 1e-9, 1e-9));
    }
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("drive.bag");
};

TEST_F(RosBagReaderTest, ScansKeepTheirStampsRaysAndLimits)
{
  std::vector<float> range_m = kRanges;
  range_m[0] = 0.01f;
  range_m[1] = 31;
  range_m[2] = std::numeric_limits<float>::infinity();
  range_m[180] = 4;
  {
    RosBagWriter bag(path_);
    bag.scan("/scan", 1000.25, range_m);
  }
  const auto read = frames();
  ASSERT_EQ(read.size(), 1U);
  EXPECT_DOUBLE_EQ(read[0].stamp_s, 1000.25);
  const Scan scan = ScanConverter().convert(*read[0].scan);
  ASSERT_EQ(scan.grid.count(), 181);
  EXPECT_NEAR(scan.grid.firstBearing_rad(), degToRad(-90), 1e-6);
  EXPECT_NEAR(scan.grid.increment_rad(), degToRad(1), 1e-6);
  for (const std::size_t ray : {0U, 1U, 2U}) EXPECT_FALSE(scan.valid[ray]) << ray;
  EXPECT_TRUE(scan.valid[3]);
  EXPECT_DOUBLE_EQ(scan.range_m[180], 4);
}

TEST_F(RosBagReaderTest, OdometryMessagesTellTheMotionBetweenScansAndTfTheMounting)
{
  {
    RosBagWriter bag(path_);
    bag.transform("/tf_static", 999, "base_link", "laser", {0.3, 0.1, degToRad(90)});
    for (int step = 0; step < 4; ++step)
    {
      bag.odometry("/odom", 1000 + 0.1 * step, poseAt(step));
      bag.scan("/scan", 1000 + 0.1 * step, kRanges);
    }
  }
  const auto read = frames();
  expectMotion(read);
  EXPECT_TRUE(
      isNearly(sensorMounting(*read[0].scan).T_robot_sensor, {0.3, 0.1, degToRad(90)}, 1e-6, 1e-6));
}

TEST_F(RosBagReaderTest, WithoutOdometryMessagesTheTransformThatMovesTheRobotServes)
{
  {
    RosBagWriter bag(path_);
    bag.transform("/tf", 999, "/base_link", "/laser", {0.3, 0, 0});
    for (int step = 0; step < 4; ++step)
    {
      bag.transform("/tf", 1000 + 0.1 * step, "/odom", "/base_link", poseAt(step));
      bag.scan("/scan", 1000 + 0.1 * step, kRanges);
    }
  }
  const auto read = frames();
  expectMotion(read);
  EXPECT_TRUE(isNearly(sensorMounting(*read[0].scan).T_robot_sensor, {0.3, 0, 0}, 1e-6, 1e-6));
}

TEST_F(RosBagReaderTest, TheMountingMayBeStatedAndElseIsSaidToBeMissing)
{
  {
    RosBagWriter bag(path_);
    for (int step = 0; step < 2; ++step)
    {
      bag.odometry("/odom", 1000 + 0.1 * step, poseAt(step));
      bag.scan("/scan", 1000 + 0.1 * step, kRanges);
    }
  }
  const auto remarks = RosBagReader(path_).remarks();
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_TRUE(says(remarks[0], {"'laser'", "'base_link'", "--bag-sensor-pose"}));
  RosBagOptions options;
  options.T_robot_sensor = Pose2{0.5, 0, degToRad(180)};
  EXPECT_TRUE(RosBagReader(path_, std::nullopt, options).remarks().empty());
  EXPECT_TRUE(isNearly(sensorMounting(*frames(options)[0].scan).T_robot_sensor,
                       *options.T_robot_sensor, 1e-6, 1e-6));
}

TEST_F(RosBagReaderTest, OfSeveralTopicsTheBusiestIsReadUnlessAnotherIsNamed)
{
  {
    RosBagWriter bag(path_);
    bag.scan("/rear", 1000, kRanges);
    for (int step = 0; step < 3; ++step) bag.scan("/front", 1000 + 0.1 * step, kRanges);
  }
  EXPECT_EQ(frames().size(), 3U);
  RosBagReader rear(path_, "rear");
  LaserFrame frame;
  EXPECT_TRUE(rear.next(frame));
  EXPECT_EQ(rear.sensorLabel(), "/rear");
  EXPECT_EQ(rear.scansOfSensors().at("/front"), 3);
  RosBagReader left(path_, "left");
  EXPECT_FALSE(left.next(frame));
  EXPECT_EQ(left.sensorLabel(), "left");
}

TEST_F(RosBagReaderTest, ABagThatWasCutSaysSo)
{
  {
    RosBagWriter bag(path_);
    for (int step = 0; step < 9; ++step) bag.scan("/scan", 1000 + 0.1 * step, kRanges);
  }
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
  LaserFrame frame;
  const auto log = openLog(path_);
  while (log->next(frame))
  {
  }
  EXPECT_TRUE(says(log->damage(), {"bag"}));
}
}  // namespace
}  // namespace psmks
#endif
