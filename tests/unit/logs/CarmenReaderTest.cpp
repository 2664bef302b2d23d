/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <psmks/geometry/Angle.h>
#include <psmks/logs/CarmenReader.h>
#include <psmks/mrpt/Convert.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/CarmenText.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

/** The error of a bearing by a float aperture. */
constexpr double kBearingTolerance_rad = 1e-7;

const std::vector<double> kRanges_m(181, 2.5);

/** The direction of a ray in the frame of the robot. */
double bearing_deg(const LaserFrame& frame, int ray)
{
  const Scan scan = ScanConverter().convert(*frame.scan);
  return radToDeg(sensorMounting(*frame.scan).T_robot_sensor.phi_rad + scan.grid.bearing_rad(ray));
}

class CarmenReaderTest : public testing::Test
{
 protected:
  std::vector<LaserFrame> framesOf(const std::string& text, const CarmenOptions& options = {},
                                   const std::optional<std::string>& sensor = std::nullopt)
  {
    std::ofstream(path_) << text;
    return read(options, sensor);
  }

  std::vector<LaserFrame> read(const CarmenOptions& options = {},
                               const std::optional<std::string>& sensor = std::nullopt)
  {
    CarmenReader reader(path_, sensor, options);
    std::vector<LaserFrame> frames;
    for (LaserFrame frame; reader.next(frame);) frames.push_back(frame);
    damage_ = reader.damage();
    remarks_ = reader.remarks();
    stampsMadeUp_ = reader.stampsMadeUp();
    scansOfSensors_ = reader.scansOfSensors();
    return frames;
  }

  void expectRemark(const std::string& words) const
  {
    for (const auto& remark : remarks_)
      if (remark.find(words) != std::string::npos) return;
    ADD_FAILURE() << "no remark '" << words << "' among " << testing::PrintToString(remarks_);
  }

  /** Expects the first and the last bearing of a FLASER with a number of rays after some
   * parameters.
   */
  void expectBearings(const std::string& parameters, std::size_t rays, double first_deg,
                      double last_deg, const CarmenOptions& options = {})
  {
    const auto frames =
        framesOf(parameters + flaser(std::vector<double>(rays, 2.5), {}, 1), options);
    ASSERT_EQ(frames.size(), 1u);
    const double tolerance_deg = radToDeg(kBearingTolerance_rad);
    EXPECT_NEAR(bearing_deg(frames[0], 0), first_deg, tolerance_deg) << rays;
    EXPECT_NEAR(bearing_deg(frames[0], static_cast<int>(rays) - 1), last_deg, tolerance_deg)
        << rays;
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.path("log");
  std::string damage_;
  std::vector<std::string> remarks_;
  std::map<std::string, int> scansOfSensors_;
  int stampsMadeUp_ = 0;
};

TEST_F(CarmenReaderTest, ScansComeWithTheirStampsRangesAndTheRobotsMotion)
{
  auto ranges_m = kRanges_m;
  ranges_m[3] = 1.25;
  const Pose2 from{1, 2, 0.5}, to{1.2, 2.1, 0.6};
  const auto frames = framesOf("# CARMEN log\n" + flaser(ranges_m, from, 1134864629.895182) +
                               "NEFF 3 0 host 0\n" + flaser(kRanges_m, to, 1134864630.125));
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(damage_, "");
  EXPECT_TRUE(remarks_.empty()) << testing::PrintToString(remarks_);
  EXPECT_NEAR(frames[0].stamp_s, 1134864629.895182, 1e-6);
  EXPECT_NEAR(mrpt::Clock::toDouble(frames[1].scan->timestamp), 1134864630.125, 1e-6);
  EXPECT_EQ(frames[0].scan->getScanRange(3), 1.25f);
  EXPECT_EQ(frames[0].scan->sensorLabel, "FLASER");
  EXPECT_FALSE(frames[0].odometry);
  EXPECT_TRUE(isNearly(*frames[1].odometry, from.inverse() * to, 1e-9, 1e-9));
}

//   number of rays even: the ray at +90 degrees is missing      \  |  /
//   number of rays odd: both ends are there                  - - - o - - -
TEST_F(CarmenReaderTest, BearingsBeginAtTheRightEndOfTheHalfCircle)
{
  expectBearings("", 180, -90, 89);
  expectBearings("", 181, -90, 90);
  expectBearings("", 360, -90, 89.5);
  expectBearings("", 361, -90, 90);
}

TEST_F(CarmenReaderTest, ParametersStateResolutionAndFieldOfView)
{
  const std::string quarter = "PARAM laser_front_laser_resolution 0.25 0 host 0\n";
  expectBearings(quarter, 401, -50, 50);
  expectBearings(quarter + "PARAM laser_front_laser_fov 180 0 host 0\n", 401, -90, 10);
  expectBearings("PARAM laser_front_laser_resolution 1 0 host 0\n", 361, -90, 90);  // not round
}

TEST_F(CarmenReaderTest, WhatTheUserKnowsGoesBeforeTheParameters)
{
  CarmenOptions options;
  options.increment_rad = degToRad(0.5);
  options.fieldOfView_rad = degToRad(270.0);
  expectBearings("PARAM laser_front_laser_resolution 0.25 0 host 0\n", 541, -135, 135, options);
  options.increment_rad.reset();
  options.fieldOfView_rad = degToRad(360.0);
  expectBearings("", 361, -180, 180 - 360.0 / 361, options);
}

TEST_F(CarmenReaderTest, AFieldOfViewThatNothingStatesIsRemarkedOn)
{
  expectBearings("", 91, -90, 90);
  expectRemark("nothing states the field of view of 91 rays");
}

// Converters write 0, SICK LMS, for any scanner; 1024 steps a turn are those of a URG alone.
TEST_F(CarmenReaderTest, TheTurnOfTheBeamIsThatOfTheScannerByItsStep)
{
  const auto beamOf = [&](const std::string& typeAndStep)
  {
    const auto space = typeAndStep.find(' ');
    const auto frames = framesOf("ROBOTLASER1 " + typeAndStep.substr(0, space) + " -0.01 0.02" +
                                 typeAndStep.substr(space) +
                                 " 5.6 0.01 0 3 1 1 1 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n");
    EXPECT_EQ(frames.size(), 1u);
    return frames.empty() ? BeamTiming{-1, 0} : frames[0].beam;
  };
  const auto beamTurn_s = [&](const std::string& typeAndStep)
  { return beamOf(typeAndStep).turn_s; };
  EXPECT_DOUBLE_EQ(beamTurn_s("0 0.006135923"), 0.1);
  EXPECT_DOUBLE_EQ(beamTurn_s("0 0.006136"), 0.1);
  EXPECT_DOUBLE_EQ(beamTurn_s("0 0.00872665"), 1.0 / 75);
  EXPECT_DOUBLE_EQ(beamTurn_s("1 0.00872665"), 1.0 / 25);
  EXPECT_DOUBLE_EQ(beamTurn_s("5 0.00872665"), 0);
  EXPECT_DOUBLE_EQ(beamOf("0 0.00872665").turnIncrement_rad, degToRad(1)) << "of an LMS";
  EXPECT_DOUBLE_EQ(beamOf("1 0.00872665").turnIncrement_rad, 0);
  EXPECT_TRUE(remarks_.empty()) << "the messages state the field of view of the three rays";
}

// 270 degrees are none of an LMS 200, whatever the type says.
TEST_F(CarmenReaderTest, ABeamThatPassesMoreThanTheHalfCircleIsNoneOfAnLms)
{
  const auto frames = framesOf(
      "ROBOTLASER1 0 -2.356 4.712 0.00436 30 0.01 0 3 1 1 1 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].beam.turn_s, 0);
}

TEST_F(CarmenReaderTest, TheLaserSitsWhereTheParametersPutIt)
{
  const std::string text =
      "PARAM robot_frontlaser_offset 0.3 0 host 0\n"
      "PARAM robot_rearlaser_offset -0.2 0 host 0\n" +
      flaser(kRanges_m, {}, 1) + "R" + flaser(kRanges_m, {}, 2).substr(1);
  const auto front = framesOf(text);
  ASSERT_EQ(front.size(), 1u);
  EXPECT_TRUE(isNearly(sensorMounting(*front[0].scan).T_robot_sensor, {0.3, 0, 0}, 1e-9, 1e-9));
  const auto rear = framesOf(text, {}, "RLASER");
  ASSERT_EQ(rear.size(), 1u);
  EXPECT_TRUE(isNearly(sensorMounting(*rear[0].scan).T_robot_sensor, {-0.2, 0, kPi}, 1e-9, 1e-9));
  EXPECT_EQ(rear[0].observations.size(), 2u);
  EXPECT_EQ(scansOfSensors_, (std::map<std::string, int>{{"FLASER", 1}, {"RLASER", 1}}));
}

TEST_F(CarmenReaderTest, ARobotLaserStatesItsScanner)
{
  // 5 rays from -100 to +100 degrees, 20 cm ahead of the robot at (1, 2), which looks to the left.
  const std::string scanner = "ROBOTLASER1 0 -1.745329252 3.490658504 0.872664626 30 0.02 0";
  const std::string poses = " 1 2.2 1.5707963268 1 2 1.5707963268 0.1 0 0.5 0.2 1e6";
  for (const std::string remissions : {"", " 0", " 5 1 2 3 4 5"})
  {
    const auto frames =
        framesOf(scanner + " 5 1 2 3 30 5" + remissions + poses + carmenStamps(7, 8));
    ASSERT_EQ(frames.size(), 1u) << remissions << testing::PrintToString(remarks_);
    EXPECT_NEAR(bearing_deg(frames[0], 0), -100, 1e-5);
    EXPECT_NEAR(bearing_deg(frames[0], 4), 100, 1e-5);
    EXPECT_TRUE(isNearly(sensorMounting(*frames[0].scan).T_robot_sensor, {0.2, 0, 0}, 1e-6, 1e-6));
    EXPECT_EQ(frames[0].scan->maxRange, 30.f);
    EXPECT_FALSE(frames[0].scan->getScanRangeValidity(3));
    EXPECT_EQ(frames[0].scan->stdError, 0.02f);
    EXPECT_EQ(frames[0].stamp_s, 7);
  }
}

/** A RAWLASER of 5 rays from -100 to +100 degrees. */
std::string rawLaser(double stamp_s, const std::string& remissions = " 0", const char* number = "1")
{
  return "RAWLASER" + std::string(number) +
         " 0 -1.745329252 3.490658504 0.872664626 30 0.02 0 5 1 2 3 30 5" + remissions +
         carmenStamps(stamp_s, stamp_s);
}

TEST_F(CarmenReaderTest, ARawLaserStatesItsScannerAndHasTheOdometryOfItsTime)
{
  for (const std::string remissions : {"", " 0", " 5 1 2 3 4 5"})
  {
    const auto frames =
        framesOf("PARAM robot_frontlaser_offset 0.3 0 host 0\n" + odom({1, 0, 0}, 1.0) +
                 rawLaser(1.0, remissions) + odom({1.4, 0, 0}, 2.0) + rawLaser(2.5, remissions));
    ASSERT_EQ(frames.size(), 2u) << remissions << damage_;
    EXPECT_NEAR(bearing_deg(frames[0], 0), -100, 1e-5);
    EXPECT_NEAR(bearing_deg(frames[0], 4), 100, 1e-5);
    EXPECT_EQ(frames[0].scan->maxRange, 30.f);
    EXPECT_FALSE(frames[0].scan->getScanRangeValidity(3));
    EXPECT_TRUE(isNearly(sensorMounting(*frames[0].scan).T_robot_sensor, {0.3, 0, 0}, 1e-6, 1e-6));
    ASSERT_TRUE(frames[1].odometry);
    EXPECT_TRUE(isNearly(*frames[1].odometry, {0.6, 0, 0}, 1e-9, 1e-9)) << "0.4 m/s, for 1.5 s";
    EXPECT_TRUE(remarks_.empty()) << testing::PrintToString(remarks_);
  }
}

TEST_F(CarmenReaderTest, ARawLaserLooksAheadAndTheSecondBack)
{
  const auto frames = framesOf(rawLaser(1, "", "2"));
  ASSERT_EQ(frames.size(), 1u) << damage_;
  EXPECT_NEAR(std::abs(bearing_deg(frames[0], 2)), 180, 1e-5);
}

TEST_F(CarmenReaderTest, RawLasersAreLeftOutWhereTheSameScansComeWithAPose)
{
  const std::string both = rawLaser(1) + flaser(kRanges_m, {}, 1) + rawLaser(2) +
                           flaser(kRanges_m, {0.1, 0, 0}, 2) + rawLaser(3);
  EXPECT_EQ(framesOf(both).size(), 2u);
  EXPECT_EQ(scansOfSensors_, (std::map<std::string, int>{{"FLASER", 2}}));
  EXPECT_EQ(framesOf(both, {}, "RAWLASER1").size(), 3u) << "where it is asked for";
  const std::string rare = flaser(kRanges_m, {}, 1) + rawLaser(1) + rawLaser(2) + rawLaser(3);
  framesOf(rare);
  EXPECT_EQ(scansOfSensors_.at("RAWLASER1"), 3) << "one scan is no repetition of three";
}

TEST_F(CarmenReaderTest, AByteOrderMarkAndNulsLoseNoScan)
{
  const std::string nuls(3, '\0');
  EXPECT_EQ(framesOf("\xEF\xBB\xBF" + flaser(kRanges_m, {}, 1)).size(), 1u);
  EXPECT_EQ(framesOf(nuls + flaser(kRanges_m, {}, 1) + flaser(kRanges_m, {}, 2)).size(), 2u);
}

TEST_F(CarmenReaderTest, AbsurdParametersCountForNothing)
{
  for (const char* value : {"5e-324", "1e-300", "1e300", "1e18", "-1", "0", "nan", "inf"})
  {
    std::string parameters;
    for (const char* name : {"laser_front_laser_resolution", "laser_front_laser_fov",
                             "robot_frontlaser_offset", "robot_frontlaser_side_offset"})
      parameters += "PARAM " + std::string(name) + ' ' + value + " 0 host 0\n";
    const auto frames = framesOf(parameters + flaser(kRanges_m, {}, 1));
    ASSERT_EQ(frames.size(), 1u) << value;
    EXPECT_NEAR(bearing_deg(frames[0], 0), -90, 1e-5) << value;
    EXPECT_LT(sensorMounting(*frames[0].scan).T_robot_sensor.translation().norm(), 2) << value;
  }
}

TEST_F(CarmenReaderTest, AbsurdPosesAndScannersOfMessagesHarmNothing)
{
  framesOf(flaser(kRanges_m, {1e300, 0, 0}, 1) + flaser(kRanges_m, {0, 0, 1e300}, 1) +
           flaser(kRanges_m, {}, 1));
  expectRemark("2 malformed messages skipped");
  for (const char* number : {"1e300", "-1e300", "5e-324", "7"})
    for (std::size_t field = 1; field <= 7; ++field)
    {
      std::string text = rawLaser(1);
      std::size_t at = 0;
      for (std::size_t i = 0; i < field; ++i) at = text.find(' ', at) + 1;
      text.replace(at, text.find(' ', at) - at, number);
      EXPECT_EQ(framesOf(text).size(), 1u) << text;
    }
}

TEST_F(CarmenReaderTest, ALogOfMalformedMessagesAloneIsDamaged)
{
  EXPECT_EQ(framesOf("FLASER 3 1 2\nODOM 1\n").size(), 0u);
  EXPECT_EQ(damage_, "none of its 2 messages can be read, the first in line 1");
}

TEST_F(CarmenReaderTest, RangesThatAreNoReturnsAreFlagged)
{
  auto ranges_m = kRanges_m;
  ranges_m[1] = 81.91;
  ranges_m[2] = 81.83;
  ranges_m[3] = 0;
  std::string text = flaser(ranges_m, {}, 1);
  text.replace(text.find(" 2.5"), 4, " NaN");
  const auto frames = framesOf(text);
  ASSERT_EQ(frames.size(), 1u);
  for (std::size_t ray : {0u, 1u, 2u, 3u})
    EXPECT_FALSE(frames[0].scan->getScanRangeValidity(ray)) << ray;
  EXPECT_TRUE(frames[0].scan->getScanRangeValidity(4));
  EXPECT_EQ(frames[0].scan->maxRange, 80.f);
}

TEST_F(CarmenReaderTest, TheRangeLimitIsThatOfTheUserOrOfTheParameters)
{
  const std::string text = "PARAM robot_front_laser_max 2.5 0 host 0\n" + flaser(kRanges_m, {}, 1);
  EXPECT_FALSE(framesOf(text)[0].scan->getScanRangeValidity(4));
  CarmenOptions options;
  options.maxRange_m = 3;
  EXPECT_TRUE(framesOf(text, options)[0].scan->getScanRangeValidity(4));
}

TEST_F(CarmenReaderTest, OdomMessagesStandInForScansWithoutOdometry)
{
  const auto frames =
      framesOf(odom({0, 0, 0}, 1.0) + flaser(kRanges_m, {}, 1.0) + odom({0.1, 0, 0}, 1.5) +
               odom({0.3, 0, 0}, 2.0) + flaser(kRanges_m, {}, 2.0));
  ASSERT_EQ(frames.size(), 2u);
  ASSERT_TRUE(frames[1].odometry);
  EXPECT_TRUE(isNearly(*frames[1].odometry, {0.3, 0, 0}, 1e-9, 1e-9));
  expectRemark("that of the ODOM messages stands in");
}

TEST_F(CarmenReaderTest, StampsAreIpcsUnlessTheyAreZeroOrTheUserWantsTheLoggers)
{
  const std::string both = flaser(kRanges_m, {}, 100, 1) + flaser(kRanges_m, {}, 101, 2);
  EXPECT_EQ(framesOf(both)[0].stamp_s, 100);
  CarmenOptions options;
  options.stamp = CarmenStamp::Logger;
  EXPECT_EQ(framesOf(both, options)[0].stamp_s, 1);
  EXPECT_EQ(framesOf(flaser(kRanges_m, {}, 0, 1) + flaser(kRanges_m, {}, 0, 2))[1].stamp_s, 2);
  EXPECT_EQ(stampsMadeUp_, 0);
}

TEST_F(CarmenReaderTest, WhereBothStampsAreZeroTheyAreMadeUp)
{
  std::string nobodysLog = flaser(kRanges_m, {}, 0) + flaser(kRanges_m, {}, 0);
  const auto frames = framesOf(nobodysLog);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(stampsMadeUp_, 2);
  EXPECT_GT(frames[1].stamp_s, frames[0].stamp_s);
  EXPECT_EQ(frames[0].scan->timestamp, INVALID_TIMESTAMP);
}

TEST_F(CarmenReaderTest, StampsThatRepeatOrGoBackAreKeptAndRemarkedOn)
{
  std::string text;
  for (const double stamp_s : {1.0, 2.0, 2.0, 1.5, 3.0}) text += flaser(kRanges_m, {}, stamp_s);
  const auto frames = framesOf(text);
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_EQ(frames[3].stamp_s, 1.5);
  expectRemark("1 scan with the stamp of the scan before, in line 3");
  expectRemark("1 scan with an earlier stamp than the scan before, in line 4");
}

TEST_F(CarmenReaderTest, MalformedMessagesAreSkippedAndCounted)
{
  const std::string good = flaser(kRanges_m, {}, 1);
  std::string tooFew = good, tooMany = good, noNumber = good, noPose = good;
  tooFew.replace(tooFew.find(" 2.5"), 4, "");
  tooMany.replace(tooMany.find(" 2.5"), 4, " 2.5 2.5");
  noNumber.replace(noNumber.find(" 2.5"), 4, " 2,5");
  noPose.replace(noPose.find(" 9 9"), 4, " 9 nan");
  const auto frames =
      framesOf(good + tooFew + tooMany + noNumber + noPose + "FLASER\nFLASER -3 1 2\n" +
               "ODOM 1 2 3\n" + good.substr(0, 200) + "\n" + flaser(kRanges_m, {}, 2));
  EXPECT_EQ(frames.size(), 2u);
  expectRemark("8 malformed messages skipped, the first in line 2");
  EXPECT_EQ(damage_, "");
}

TEST_F(CarmenReaderTest, LinesMayEndAsOnDos)
{
  std::string text = flaser(kRanges_m, {}, 1);
  text.insert(text.size() - 1, "\r");
  EXPECT_EQ(framesOf(text).size(), 1u);
}

TEST_F(CarmenReaderTest, MissingEmptyAndForeignFilesAreDamage)
{
  read();
  EXPECT_NE(damage_.find("no such file"), std::string::npos);
  framesOf("");
  EXPECT_EQ(damage_, "the file is empty");
  framesOf("Dear diary,\ntoday\n");
  EXPECT_NE(damage_.find("not a CARMEN log: none of its 2 lines"), std::string::npos) << damage_;
}

TEST_F(CarmenReaderTest, ACutGzippedLogYieldsTheScansBeforeTheCut)
{
  mrpt::io::CFileGZOutputStream file(path_);
  for (int i = 1; i <= 400; ++i)
  {
    std::vector<double> ranges_m;
    for (int ray = 0; ray < 181; ++ray) ranges_m.push_back(1 + (i * 37 + ray * 101) % 997 * 0.01);
    const std::string message = flaser(ranges_m, {}, i);
    file.Write(message.data(), message.size());
  }
  file.close();
  ASSERT_EQ(read().size(), 400u);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
  const auto frames = read();
  EXPECT_GT(frames.size(), 100u);
  EXPECT_LT(frames.size(), 300u);
  EXPECT_EQ(damage_, "read " + std::to_string(frames.size()) +
                         " messages, then: the compressed data is cut off");
  EXPECT_TRUE(remarks_.empty()) << testing::PrintToString(remarks_);
}

TEST_F(CarmenReaderTest, ARealLogIsReadWhole)
{
  const char* folder = std::getenv("PSMKS_DATA_DIR");
  if (!folder) GTEST_SKIP() << "PSMKS_DATA_DIR is not set";
  CarmenReader reader(std::string(folder) + "/csail.log.gz");
  double path_m = 0;
  int scans = 0;
  for (LaserFrame frame; reader.next(frame); ++scans)
    if (frame.odometry) path_m += frame.odometry->translation().norm();
  EXPECT_EQ(scans, 1051);
  EXPECT_NEAR(path_m, 373.2, 0.1);
  EXPECT_EQ(reader.damage(), "");
  EXPECT_TRUE(reader.remarks().empty());
}
}  // namespace
}  // namespace psmks
