/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/CarmenSurvey.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/CarmenText.h>

#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

const std::vector<double> kRanges_m{1, 2, 3, 4, 5};

/** A ROBOTLASER1 message without remissions: a scanner of 180 degrees at `sensor` on the robot. */
std::string robotLaser(const Pose2& sensor, const Pose2& odometry, double stamp_s)
{
  return "ROBOTLASER1 0 -1.5708 3.1416 0.7854 50 0.01 0" + carmenRanges(kRanges_m) + " 0" +
         carmenPose(odometry * sensor) + carmenPose(odometry) + " 0 0 0 0 0" +
         carmenStamps(stamp_s, stamp_s);
}

class CarmenSurveyTest : public testing::Test
{
 protected:
  CarmenSurvey survey(const std::string& text) const
  {
    std::ofstream(path_) << text;
    return surveyCarmenLog(path_);
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.path("log");
};

TEST_F(CarmenSurveyTest, CountsLinesMessagesAndScans)
{
  const CarmenSurvey log =
      survey("# a comment\n" + odom({0, 0, 0}, 1) + flaser(kRanges_m, {0, 0, 0}, 2) +
             flaser(kRanges_m, {1, 0, 0}, 3) + "PARAM laser_max 30 1 h 1\n");
  EXPECT_TRUE(log.exists);
  EXPECT_EQ(log.error, "");
  EXPECT_EQ(log.lines, 5);
  EXPECT_EQ(log.messages, 4);
  EXPECT_EQ(log.firstSensor, "FLASER");
  EXPECT_EQ(log.sensors.at("FLASER").scans, 2);
  EXPECT_EQ(log.sensors.at("FLASER").rays, 5);
  EXPECT_EQ(log.parameters.at("laser_max"), 30);
}

TEST_F(CarmenSurveyTest, KnowsTheFirstMalformedLine)
{
  const std::string scan = flaser(kRanges_m, {0, 0, 0}, 1);
  const CarmenSurvey log = survey(scan + "FLASER 5 1 2\n" + scan + "ODOM 1 x 0\n");
  EXPECT_EQ(log.malformed.times, 2);
  EXPECT_EQ(log.malformed.firstLine, 2);
  EXPECT_EQ(log.sensors.at("FLASER").scans, 2);
}

TEST_F(CarmenSurveyTest, TakesTheFirstStampThatChanges)
{
  const CarmenSurvey both = survey(flaser(kRanges_m, {}, 1, 5) + flaser(kRanges_m, {}, 2, 6));
  EXPECT_EQ(both.stampOf("FLASER", std::nullopt), CarmenStamp::Ipc);
  EXPECT_EQ(both.stampOf("FLASER", CarmenStamp::Logger), CarmenStamp::Logger);

  const CarmenSurvey frozen = survey(flaser(kRanges_m, {}, 1, 5) + flaser(kRanges_m, {}, 1, 6));
  EXPECT_EQ(frozen.stampOf("FLASER", std::nullopt), CarmenStamp::Logger);
  EXPECT_EQ(frozen.stampOf("FLASER", CarmenStamp::Ipc), std::nullopt);

  const CarmenSurvey none = survey(flaser(kRanges_m, {}, 0, 0) + flaser(kRanges_m, {}, 0, 0));
  EXPECT_EQ(none.stampOf("FLASER", std::nullopt), std::nullopt);
  EXPECT_EQ(none.stampOf("RLASER", std::nullopt), std::nullopt);
}

TEST_F(CarmenSurveyTest, FindsStampsThatRepeatOrGoBackwards)
{
  const CarmenSurvey log = survey(flaser(kRanges_m, {}, 1) + flaser(kRanges_m, {}, 1) +
                                  flaser(kRanges_m, {}, 3) + flaser(kRanges_m, {}, 2));
  const CarmenStampSurvey& ipc = log.sensors.at("FLASER").ipc;
  EXPECT_EQ(ipc.repeated.times, 1);
  EXPECT_EQ(ipc.repeated.firstLine, 2);
  EXPECT_EQ(ipc.backwards.times, 1);
  EXPECT_EQ(ipc.backwards.firstLine, 4);
}

TEST_F(CarmenSurveyTest, ReadsTheOdometryWhereTheRobotMoves)
{
  const std::string moving = flaser(kRanges_m, {0.5, 0, 0}, 1), resting = flaser(kRanges_m, {}, 1);
  EXPECT_EQ(survey(moving).odometryOf("FLASER"), CarmenOdometry::Scans);
  EXPECT_EQ(survey(resting + odom({1, 0, 0}, 2)).odometryOf("FLASER"),
            CarmenOdometry::OdometryMessages);
  EXPECT_EQ(survey(resting + odom({0, 0, 0}, 2)).odometryOf("FLASER"), CarmenOdometry::None);
}

TEST_F(CarmenSurveyTest, FindsTheMountingOfAScannerAndWhetherItStays)
{
  const Pose2 mounting{0.2, 0.1, 0.3}, odometry{5, -2, 1}, moved{0.25, 0.1, 0.3};
  const CarmenSurvey fixed =
      survey(robotLaser(mounting, {}, 1) + robotLaser(mounting, odometry, 2));
  const CarmenSensorSurvey& sensor = fixed.sensors.at("ROBOTLASER1");
  EXPECT_NEAR(sensor.T_robot_sensor.x_m, 0.2, 1e-9);
  EXPECT_NEAR(sensor.T_robot_sensor.y_m, 0.1, 1e-9);
  EXPECT_NEAR(sensor.T_robot_sensor.phi_rad, 0.3, 1e-9);
  EXPECT_FALSE(sensor.mountingVaries);

  const CarmenSurvey loose = survey(robotLaser(mounting, {}, 1) + robotLaser(moved, odometry, 2));
  EXPECT_TRUE(loose.sensors.at("ROBOTLASER1").mountingVaries);
}

TEST_F(CarmenSurveyTest, SaysThatTheFileIsMissing)
{
  const CarmenSurvey log = surveyCarmenLog(folder_.path("absent"));
  EXPECT_FALSE(log.exists);
  EXPECT_EQ(log.lines, 0);
}
}  // namespace
}  // namespace psmks
