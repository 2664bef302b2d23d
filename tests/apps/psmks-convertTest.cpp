/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/RawlogReader.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ProgramTest.h>
#include <tests/unit/logs/CarmenText.h>
#include <tests/unit/logs/RoomLog.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

constexpr int kScans = 8;

class PsmksConvert : public test::ProgramTest
{
 protected:
  PsmksConvert() : ProgramTest(PSMKS_PROGRAM) {}

  void expectSuccess(const std::string& arguments, const std::string& output) const
  {
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    EXPECT_EQ(done.output, output);
  }

  /** Expects one sentence on stderr and no output file. */
  void expectRefusal(const std::string& arguments, int exitCode, const std::string& sentence) const
  {
    SCOPED_TRACE(arguments);
    expectError(run(arguments), exitCode, {sentence});
    EXPECT_FALSE(std::filesystem::exists(path("out.rawlog")));
  }

  std::vector<LaserFrame> framesOf(const std::string& name) const
  {
    const auto reader = openLog(path(name));
    std::vector<LaserFrame> frames;
    for (LaserFrame frame; reader->next(frame);) frames.push_back(frame);
    EXPECT_EQ(reader->damage(), "");
    return frames;
  }

  /** Expects the stamps, the odometry, the bearings and the ranges of the log of the room. */
  void expectRoom(const std::string& name) const
  {
    const auto frames = framesOf(name);
    ASSERT_EQ(frames.size(), log_.steps.size()) << name;
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      const RoomLog::Step& step = log_.steps[i];
      EXPECT_NEAR(frames[i].stamp_s, step.stamp_s, 1e-6);
      const Pose2 odometry = i > 0 ? *frames[i].odometry : step.odometryIncrement;
      EXPECT_TRUE(isNearly(odometry, step.odometryIncrement, 1e-6, 1e-6));
      const Scan scan = ScanConverter().convert(*frames[i].scan);
      const Scan truth = ScanConverter().convert(*step.scan);
      EXPECT_EQ(scan.valid, truth.valid);
      EXPECT_NEAR(scan.grid.firstBearing_rad(), truth.grid.firstBearing_rad(), 1e-7);
      EXPECT_NEAR(scan.grid.increment_rad(), truth.grid.increment_rad(), 1e-9);
      EXPECT_TRUE(isNearly(sensorMounting(*frames[i].scan).T_robot_sensor,
                           sensorMounting(*step.scan).T_robot_sensor, 1e-9, 1e-9));
      for (std::size_t ray = 0; ray < scan.range_m.size(); ++ray)
        EXPECT_TRUE(!scan.valid[ray] || scan.range_m[ray] == truth.range_m[ray]) << ray;
    }
  }

  void writeTruth(const std::string& name) const
  {
    Trajectory truth;
    for (const auto& step : log_.steps) truth.push_back({step.stamp_s, step.T_world_robot});
    std::ofstream file(path(name));
    writeTum(file, truth);
  }

  const RoomLog log_{kScans};
};

TEST_F(PsmksConvert, ARawlogGoesToCarmenAndBackUnchanged)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  expectSuccess("room.rawlog room.log", "room.log: 8 scans of 'FRONT'\n");
  expectRoom("room.log");
  expectSuccess("room.log back.rawlog", "back.rawlog: 8 scans of 'ROBOTLASER1'\n");
  expectRoom("back.rawlog");
  expectSuccess("back.rawlog again.clf.gz", "again.clf.gz: 8 scans of 'ROBOTLASER1'\n");
  expectRoom("again.clf.gz");
  EXPECT_EQ(fileText(path("again.clf.gz")).substr(0, 2), "\x1f\x8b");
}

TEST_F(PsmksConvert, BothKindsOfRawlogHoldTheSame)
{
  writeCarmen(log_, path("room.log"));
  EXPECT_EQ(run("room.log loose.rawlog --observations").exitCode, 0);
  EXPECT_EQ(run("room.log paired.rawlog").exitCode, 0);
  expectRoom("loose.rawlog");
  expectRoom("paired.rawlog");
  EXPECT_NE(fileText(path("loose.rawlog")), fileText(path("paired.rawlog")));
}

TEST_F(PsmksConvert, FlagsSayWhatACarmenLogDoesNot)
{
  std::ofstream(path("a.log")) << flaser(std::vector<double>(541, 2.0), {}, 100, 1)
                               << flaser(std::vector<double>(541, 2.0), {1, 0, 0}, 101, 2);
  EXPECT_EQ(run("a.log a.rawlog --carmen-resolution_deg 0.5 --carmen-fov_deg 270 "
                "--carmen-max-range_m 30 --carmen-stamps logger --max-scans 1")
                .exitCode,
            0);
  const auto frames = framesOf("a.rawlog");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].scan->aperture, static_cast<float>(degToRad(270.0)));
  EXPECT_EQ(frames[0].scan->maxRange, 30.f);
  EXPECT_EQ(frames[0].stamp_s, 1);
}

TEST_F(PsmksConvert, PairsHaveTheTrueMotionAndTheOdometry)
{
  writeCarmen(log_, path("room.log"));
  writeTruth("room.tum");
  expectSuccess("room.log room.pairs.gz --ground-truth room.tum",
                "room.pairs.gz: 7 pairs of 'ROBOTLASER1'\n");
  expectSuccess("room.log room.pairs --ground-truth room.tum --every 3",
                "room.pairs: 2 pairs of 'ROBOTLASER1'\n");
  PairsReader reader(path("room.pairs"));
  ScanPair pair;
  ASSERT_TRUE(reader.read(pair));
  const Pose2 T_robot_sensor = sensorMounting(*log_.steps[0].scan).T_robot_sensor;
  const auto ofSensors = [&](const Pose2& T_ref_cur)
  { return T_robot_sensor.inverse() * T_ref_cur * T_robot_sensor; };
  const Pose2 step = log_.steps[1].odometryIncrement;
  EXPECT_TRUE(isNearly(pair.T_ref_cur_true, ofSensors(log_.steps[3].T_world_robot), 1e-6, 1e-6));
  EXPECT_TRUE(isNearly(pair.T_ref_cur_odometry, ofSensors(step * step * step), 1e-6, 1e-6));
}

TEST_F(PsmksConvert, ScansWithoutATruePoseAreLeftOutAndCounted)
{
  writeCarmen(log_, path("room.log"));
  std::ofstream file(path("short.tum"));
  writeTum(file, {{log_.steps[0].stamp_s, {}}, {log_.steps[1].stamp_s, {}}});
  file.close();
  expectSuccess("room.log room.pairs --ground-truth short.tum",
                "room.pairs: 1 pairs; 6 scans without a true pose left out of 'ROBOTLASER1'\n");
  std::ofstream(path("late.tum")) << "1 0 0 0 0 0 0 1\n";
  EXPECT_EQ(run("room.log late.pairs --ground-truth late.tum").exitCode, 3);
  EXPECT_FALSE(std::filesystem::exists(path("late.pairs")));
}

TEST_F(PsmksConvert, AMapBecomesItsWalls)
{
  std::ofstream(path("room.map")) << "2D-Map\nNumPoints: 1\nLINES\n0 0 4000 0\n4000 0 4000 2500\n"
                                     "DATA\n1000 1000\n";
  expectSuccess("room.map room.csv", "room.csv: 2 segments; the map's 1 points are left out\n");
  EXPECT_EQ(fileText(path("room.csv")), "x1_m,y1_m,x2_m,y2_m\n0,0,4,0\n4,0,4,2.5\n");
}

TEST_F(PsmksConvert, WhatIsReadBeforeTheDamageIsConverted)
{
  writePlain(asFrames(log_), path("cut.rawlog"));
  std::filesystem::resize_file(path("cut.rawlog"),
                               std::filesystem::file_size(path("cut.rawlog")) * 6 / 10);
  const ProgramRun done = run("cut.rawlog cut.log");
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_NE(done.errors.find("the file ends within entry 10"), std::string::npos) << done.errors;
  EXPECT_EQ(framesOf("cut.log").size(), 4u);
}

TEST_F(PsmksConvert, MalformedMessagesAreTold)
{
  writeCarmen(log_, path("room.log"));
  std::ofstream(path("room.log"), std::ios::app) << "FLASER 3 1 2\nODOM 1 2\n";
  const ProgramRun done = run("room.log room.rawlog");
  EXPECT_EQ(done.exitCode, 0);
  EXPECT_NE(done.errors.find("2 malformed messages skipped, the first in line 10"),
            std::string::npos)
      << done.errors;
  expectRoom("room.rawlog");
}

TEST_F(PsmksConvert, InputsThatHoldNothingEndWithTheirExitCodes)
{
  std::ofstream(path("empty.log")).close();
  std::ofstream(path("prose.log")) << "Dear diary,\ntoday\n";
  std::ofstream(path("scanless.log")) << odom({1, 2, 3}, 4);
  writeCarmen(log_, path("room.log"));
  expectRefusal("none.log out.rawlog", 2, "no such file");
  expectRefusal("empty.log out.rawlog", 2, "the file is empty");
  expectRefusal("prose.log out.rawlog", 2, "not a CARMEN log");
  expectRefusal("scanless.log out.rawlog", 3, "no 2D laser scan");
  expectRefusal("room.log out.rawlog --sensor RLASER", 3, "of 'ROBOTLASER1' (8 scans)");
  expectRefusal("none.map walls.csv", 2, "no such file");
  expectRefusal("room.log walls.csv", 2, "room.log");
}

TEST_F(PsmksConvert, WrongCommandLinesEndWithOneSentence)
{
  writeCarmen(log_, path("room.log"));
  expectRefusal("room.log", 1, "OUTPUT");
  expectRefusal("room.log out.txt", 1, "ends neither in .rawlog");
  expectRefusal("room.log out.pairs", 1, "--ground-truth");
  expectRefusal("room.log no/folder/out.rawlog", 1, "cannot write 'no/folder/out.rawlog'");
  expectRefusal("room.log no/folder/out.log", 1, "cannot write 'no/folder/out.log'");
  expectRefusal("room.log room.log --overwrite", 1, "is the input");
  expectRefusal("room.log out.rawlog --carmen-stamps clock", 1, "clock");
  std::ofstream(path("there.rawlog")) << "precious";
  expectRefusal("room.log there.rawlog", 1, "--overwrite");
  EXPECT_EQ(fileText(path("there.rawlog")), "precious");
  EXPECT_EQ(run("room.log there.rawlog --overwrite").exitCode, 0);
}

TEST_F(PsmksConvert, HelpShowsExamples)
{
  const ProgramRun help = run("--help");
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_NE(help.output.find("psmks-convert fr079.log.gz fr079.rawlog"), std::string::npos);
  EXPECT_EQ(run("--version").output.rfind("psmks-convert 0.", 0), 0u);
}
}  // namespace
TEST_F(PsmksConvert, ReportsTheNoiseOfAScanner)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  const ProgramRun told = run(path("room.rawlog") + " --sensor-report");
  EXPECT_EQ(told.exitCode, 0) << told.errors;
  EXPECT_NE(told.output.find("straight walls"), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("odd minus even rays"), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("the scanner never stood"), std::string::npos) << told.output;

  const ProgramRun written = run(path("room.rawlog") + " " + path("room.ini") + " --sensor-report");
  EXPECT_EQ(written.exitCode, 0) << written.errors;
  EXPECT_NE(fileText(path("room.ini")).find("range_sigma_m = "), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("room.png")));
}

TEST_F(PsmksConvert, ASensorFileNeedsTheReport)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  expectError(run(path("room.rawlog") + " " + path("room.ini")), 1, {"--sensor-report"});
  expectError(run(path("room.rawlog") + " " + path("room.csv") + " --sensor-report"), 1, {".ini"});
  expectError(run(path("room.rawlog")), 1, {"OUTPUT is required"});
}
}  // namespace psmks
