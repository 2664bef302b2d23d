/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <tests/support/Program.h>
#include <tests/unit/mrpt/RoomLog.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using namespace test;
using nlohmann::json;

constexpr int kScans = 8;

class PsmksBenchmarkLogs : public testing::Test
{
 protected:
  void SetUp() override
  {
    std::filesystem::create_directories(folder_);
    writeGzipped(asFrames(log_), log("room"));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string log(const std::string& name) const { return path(name + ".rawlog"); }

  ProgramRun run(const std::string& arguments) const
  {
    return runProgram("'" PSMKS_PROGRAM "' logs " + arguments + " --json " + path("t.json"));
  }

  json rows(std::size_t table = 0) const
  {
    return json::parse(fileText(path("t.json"))).at("tables").at(table).at("rows");
  }

  /** @param sideways_m by which the last pose is wrong */
  void writeTruth(const std::string& name, double sideways_m = 0) const
  {
    Trajectory truth;
    for (const auto& step : log_.steps) truth.push_back({step.stamp_s, step.T_world_robot});
    truth.back().pose.y_m += sideways_m;
    std::ofstream out(path(name));
    writeTum(out, truth);
  }

  const RoomLog log_{kScans};
  const std::string folder_ = testing::TempDir() + "psmks-benchmark-logs_" +
                              testing::UnitTest::GetInstance()->current_test_info()->name();
};
}  // namespace

TEST_F(PsmksBenchmarkLogs, everyMatcherRunsWithEveryReferenceAndTheOdometryOnce)
{
  const ProgramRun done = run(log("room") + " --matchers psmks,icp-classic,guess --repeats 2");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  ASSERT_EQ(rows().size(), 7U);
  for (const auto& row : rows()) EXPECT_EQ(row.at("scans"), kScans) << row;
  EXPECT_EQ(rows()[2].at("matcher"), "psmks");
  EXPECT_EQ(rows()[2].at("reference"), "map");
  EXPECT_EQ(rows()[6].at("matcher"), "guess");
}

TEST_F(PsmksBenchmarkLogs, matchedScansLieSharperOnEachOtherThanTheOdometryLaysThem)
{
  ASSERT_EQ(run(log("room") + " --matchers psmks,guess --references keyframe").exitCode, 0);
  EXPECT_LT(rows()[0].at("occupied_cells_5cm"), rows()[1].at("occupied_cells_5cm"));
  EXPECT_EQ(rows()[0].at("matches"), kScans - 1);
  EXPECT_EQ(rows()[0].at("failed"), 0);
  EXPECT_NEAR(rows()[0].at("path_m"), 0.1 * (kScans - 1), 0.01);
  EXPECT_TRUE(rows()[0].at("error_mean_m").is_null()) << "there is no ground truth";
}

TEST_F(PsmksBenchmarkLogs, theGroundTruthBesideTheLogIsFound)
{
  for (const char* name : {"room.gt.tum", "room.GT.txt", "room.rawlog.GT.txt"})
  {
    writeTruth(name);
    ASSERT_EQ(run(log("room") + " --matchers psmks,guess --references map").exitCode, 0);
    EXPECT_LT(rows()[0].at("error_max_m"), 0.01) << name;
    EXPECT_GT(rows()[1].at("error_max_m"), 0.02) << name;
    std::filesystem::remove(path(name));
  }
}

TEST_F(PsmksBenchmarkLogs, theGroundTruthOfTheFlagCountsBeforeTheOneBesideTheLog)
{
  writeTruth("room.gt.tum");
  writeTruth("wrong.tum", 0.5);
  ASSERT_EQ(
      run(log("room") + " --matchers psmks --references map --ground-truth " + path("wrong.tum"))
          .exitCode,
      0);
  EXPECT_NEAR(rows()[0].at("error_max_m"), 0.5, 0.02);
}

TEST_F(PsmksBenchmarkLogs, optionsReachTheMatcherAndTheChoiceOfReferences)
{
  const std::string flags = " --matchers psmks --references sequential --set ";
  EXPECT_EQ(run(log("room") + flags + "preprocessing.max_range_m=0.1").exitCode, 4)
      << "no ray is below 10 cm, so every match fails";
  ASSERT_EQ(run(log("room") + flags + "reference.match_every_scan=false").exitCode, 0);
  EXPECT_LT(rows()[0].at("matches"), kScans - 1) << "most are nearer than the trigger";
}

TEST_F(PsmksBenchmarkLogs, aLogIsCutAtTheScansAskedFor)
{
  ASSERT_EQ(run(log("room") + " --matchers guess --max-scans 3").exitCode, 0);
  EXPECT_EQ(rows()[0].at("scans"), 3);
}

TEST_F(PsmksBenchmarkLogs, everyLogHasItsTableAndAMissingOneIsToldAtTheEnd)
{
  writeGzipped(asFrames(RoomLog(3)), log("short"));
  const ProgramRun done =
      run(log("room") + " " + log("absent") + " " + log("short") + " --matchers guess");
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_EQ(std::count(done.errors.begin(), done.errors.end(), '\n'), 1) << done.errors;
  EXPECT_NE(done.errors.find("absent.rawlog"), std::string::npos) << done.errors;
  EXPECT_EQ(rows(0)[0].at("scans"), kScans);
  EXPECT_EQ(rows(1)[0].at("scans"), 3);
}

TEST_F(PsmksBenchmarkLogs, aLogWithoutScansIsNothingToDo)
{
  writeGzipped({makeOdometry(log_.steps.front())}, log("blind"));
  const ProgramRun done = run(log("blind") + " --matchers guess");
  EXPECT_EQ(done.exitCode, 3);
  EXPECT_NE(done.errors.find("holds no usable 2D laser scan"), std::string::npos) << done.errors;
}

TEST_F(PsmksBenchmarkLogs, whatCannotBeAcceptedIsAUsageError)
{
  const auto expectUsageError = [this](const std::string& arguments, const std::string& sentence)
  {
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exitCode, 1) << arguments;
    EXPECT_NE(done.errors.find(sentence), std::string::npos) << done.errors;
  };
  const std::string room = log("room");
  expectUsageError(room + " --matchers nobody", "matcher 'nobody' is not known");
  expectUsageError(room + " --references moon", "moon");
  expectUsageError(room + " --set joint.nothing=1", "'nothing'");
  expectUsageError(room + " " + room + " --ground-truth t.tum", "belongs to one LOG");
  expectUsageError("robot.log", "is a CARMEN log by its name");
}

TEST_F(PsmksBenchmarkLogs, aGroundTruthThatCannotBeReadIsAnInputError)
{
  const ProgramRun done = run(log("room") + " --matchers guess --ground-truth " + path("no.tum"));
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_NE(done.errors.find("ground truth"), std::string::npos) << done.errors;
}
}  // namespace psmks
