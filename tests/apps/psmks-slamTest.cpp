/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/RawlogReader.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ProgramTest.h>
#include <tests/unit/logs/CarmenText.h>
#include <tests/unit/logs/RoomLog.h>

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
constexpr const char* kSena =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
const char* const kResults[] = {"trajectory.tum", "odometry.tum", "matches.csv",   "graph.g2o",
                                "map.pgm",        "map.yaml",     "segments.csv",  "map.svg",
                                "map.png",        "map.3Dscene",  "map.simplemap", "summary.json"};

std::string quoted(const std::string& path) { return "'" + path + "'"; }

class PsmksSlam : public test::ProgramTest
{
 protected:
  PsmksSlam() : ProgramTest(PSMKS_PROGRAM) {}

  /** Runs the program on a log, with the folder "out" for its results. */
  ProgramRun slam(const std::string& log, const std::string& flags = "") const
  {
    return run(quoted(path(log)) + " --output out --overwrite " + flags);
  }

  Trajectory trajectory() const { return readTrajectory(path("out/trajectory.tum")); }
  json summary() const { return json::parse(fileText(path("out/summary.json"))); }

  void expectTruePath(double tol_m, double tol_rad) const
  {
    const Trajectory poses = trajectory();
    ASSERT_EQ(poses.size(), log_.steps.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
      EXPECT_TRUE(isNearly(poses[i].pose, log_.steps[i].T_world_robot, tol_m, tol_rad)) << i;
  }

  const RoomLog log_{kScans};
};

TEST_F(PsmksSlam, BothKindsOfRawlogAndBothWaysToStoreThemGiveTheTruePath)
{
  writeGzipped(asFrames(log_), path("frames.rawlog"));
  writePlain(asFrames(log_), path("plain.rawlog"));
  writeGzipped(asObservations(log_), path("observations.rawlog"));
  for (const char* name : {"frames.rawlog", "plain.rawlog", "observations.rawlog"})
  {
    const ProgramRun run = slam(name);
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    expectTruePath(2e-3, degToRad(0.05));
  }
}

TEST_F(PsmksSlam, ACarmenLogGivesTheTruePathToo)
{
  for (const char* name : {"room.log", "room.clf.gz"})
  {
    writeCarmen(log_, path(name));
    const ProgramRun run = slam(name, "--save-rawlog matched.rawlog");
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    expectTruePath(2e-3, degToRad(0.05));
    EXPECT_EQ(summary()["log"]["sensor"], "ROBOTLASER1");
  }
  EXPECT_EQ(slam("matched.rawlog", "--matcher odometry").exitCode, 0);
  expectTruePath(2e-3, degToRad(0.05));
  EXPECT_EQ(run("room.clf.gz").exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(path("room-slam/summary.json")));
}

TEST_F(PsmksSlam, WhatALogHoldsOfOddThingsIsToldAndWrittenDown)
{
  writeCarmen(log_, path("room.log"));
  std::ofstream(path("room.log"), std::ios::app) << "FLASER 3 1 2\n";
  const ProgramRun run = slam("room.log");
  EXPECT_EQ(run.exitCode, 0);
  expectOneSentence(run);
  EXPECT_NE(run.errors.find("1 malformed message skipped, in line 10"), std::string::npos)
      << run.errors;
  EXPECT_EQ(summary()["remarks"], json({"1 malformed message skipped, in line 10"}));
}

TEST_F(PsmksSlam, TheSummarySaysHowFastItWasAndWhereTheTimeWent)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  EXPECT_NE(slam("room.rawlog").output.find(" scans/s"), std::string::npos);
  EXPECT_GT(summary()["scans_per_second"], 0);
  for (const char* stage : {"reading", "segmentation", "matching", "map", "output"})
    EXPECT_GE(summary()["time_s"][stage], 0) << stage;
}

TEST_F(PsmksSlam, WritesAllItsFilesAndASummary)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  const ProgramRun run = slam("room.rawlog");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  for (const char* name : kResults) EXPECT_GT(std::filesystem::file_size(path("out/") + name), 0u);
  EXPECT_NE(run.output.find("scans            8"), std::string::npos) << run.output;
  EXPECT_EQ(summary()["scans"], kScans);
  EXPECT_EQ(summary()["matches"], kScans - 1);
  EXPECT_EQ(summary()["failures"], 0);
  EXPECT_GT(summary()["occupied_cells_5cm"], 100);
  EXPECT_EQ(summary()["options"]["matcher"]["scheme"], "joint");
}

TEST_F(PsmksSlam, TheSimplemapIsReadByMrptWithTheKeyframesOfTheRun)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  slam("room.rawlog", "--set reference.map_spacing_m=0.15");
  mrpt::maps::CSimpleMap map;
  ASSERT_TRUE(map.loadFromFile(path("out/map.simplemap")));
  EXPECT_GT(map.size(), 2u);
  EXPECT_EQ(summary()["references"], map.size());
}

TEST_F(PsmksSlam, TheOutputFolderIsNamedAfterTheLogAndNotOverwritten)
{
  writeGzipped(asFrames(log_), path("my room.rawlog"));
  EXPECT_EQ(run("'my room.rawlog'").exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(path("my room-slam/summary.json")));

  const ProgramRun again = run("'my room.rawlog'");
  EXPECT_EQ(again.exitCode, 1);
  expectOneSentence(again);
  EXPECT_NE(again.errors.find("--overwrite"), std::string::npos);
  EXPECT_EQ(run("'my room.rawlog' --overwrite").exitCode, 0);
}

TEST_F(PsmksSlam, TheSavedRawlogHoldsTheMatchedMotions)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  ASSERT_EQ(slam("room.rawlog", "--save-rawlog matched.rawlog").exitCode, 0);
  RawlogReader reader(path("matched.rawlog"));
  LaserFrame frame;
  for (std::size_t i = 0; i < log_.steps.size(); ++i)
  {
    ASSERT_TRUE(reader.next(frame));
    if (i == 0) continue;
    const Pose2 truth = log_.steps[i - 1].T_world_robot.inverse() * log_.steps[i].T_world_robot;
    EXPECT_TRUE(isNearly(*frame.odometry, truth, 2e-3, degToRad(0.05)));
  }
  EXPECT_EQ(reader.damage(), "");
  EXPECT_EQ(slam("room.rawlog --save-rawlog matched.rawlog").exitCode,
            2);  // the log does not exist
}

TEST_F(PsmksSlam, TheErrorAgainstAGroundTruthIsReported)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  std::ofstream truth(path("truth.txt"));
  truth.precision(16);
  truth << "% time x y phi\n";
  for (const auto& step : log_.steps)
    truth << step.stamp_s << ' ' << step.T_world_robot.x_m << ' ' << step.T_world_robot.y_m << ' '
          << step.T_world_robot.phi_rad << '\n';
  truth.close();
  slam("room.rawlog", "--ground-truth truth.txt");
  EXPECT_EQ(summary()["ground_truth_error"]["poses"], kScans);
  EXPECT_LT(summary()["ground_truth_error"]["max_m"], 2e-3);
  slam("room.rawlog", "--ground-truth truth.txt --matcher odometry");
  EXPECT_GT(summary()["ground_truth_error"]["max_m"], 0.02);
}

TEST_F(PsmksSlam, AGroundTruthThatCannotBeReadIsAnInputError)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  std::ofstream(path("truth.txt")) << "1 2 3\n";
  for (const char* name : {"truth.txt", "none.txt"})
  {
    const ProgramRun run = slam("room.rawlog", std::string("--ground-truth ") + name);
    EXPECT_EQ(run.exitCode, 2);
    expectOneSentence(run);
  }
}

TEST_F(PsmksSlam, AGroundTruthOfAnotherTimeIsAnInputErrorAfterEverythingIsSaved)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  std::ofstream(path("truth.txt")) << "1 0 0 0\n2 0 0 0\n";
  const ProgramRun run = slam("room.rawlog", "--ground-truth truth.txt");
  EXPECT_EQ(run.exitCode, 2);
  expectOneSentence(run);
  EXPECT_EQ(summary()["scans"], kScans);
}

TEST_F(PsmksSlam, EveryMatcherRuns)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  for (const char* matcher : {"psmks", "psmks-paper", "psm", "icp-classic", "icp-lm", "odometry"})
  {
    const ProgramRun run = slam("room.rawlog", std::string("--matcher ") + matcher);
    EXPECT_EQ(run.exitCode, 0) << matcher << ": " << run.errors;
    EXPECT_EQ(trajectory().size(), log_.steps.size()) << matcher;
  }
}

TEST_F(PsmksSlam, EveryChoiceOfReferenceFollowsTheTruePath)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  for (const char* choice : {"sequential", "keyframe", "map"})
  {
    const ProgramRun run = slam("room.rawlog", std::string("--reference ") + choice);
    ASSERT_EQ(run.exitCode, 0) << choice << ": " << run.errors;
    EXPECT_EQ(summary()["options"]["reference"]["choice"], choice);
    expectTruePath(2e-3, degToRad(0.05));
  }
}

TEST_F(PsmksSlam, AMapHasAKeyframeForEverySpacing)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  slam("room.rawlog", "--reference map");
  EXPECT_EQ(summary()["references"],
            2);  // the path turns by 35 degrees, references are 30 degrees apart
  slam("room.rawlog", "--reference map --set reference.map_spacing_m=0.15");
  EXPECT_GT(summary()["references"], 3);
  expectTruePath(2e-3, degToRad(0.05));
}

TEST_F(PsmksSlam, ScansWithoutAnyOdometryAreMatchedFromTheLastMotion)
{
  Entries entries;
  for (const auto& step : log_.steps) entries.push_back(step.scan);
  writeGzipped(entries, path("scans.rawlog"));
  ASSERT_EQ(slam("scans.rawlog").exitCode, 0);
  expectTruePath(2e-3, degToRad(0.05));
  const ProgramRun odometry = slam("scans.rawlog", "--matcher odometry");
  EXPECT_EQ(odometry.exitCode, 3);
  expectOneSentence(odometry);
}

TEST_F(PsmksSlam, UnsetStampsCommentsAndASecondScannerDoNotDisturb)
{
  const auto rear = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(
      log_.steps[0].scan->duplicateGetSmartPtr());
  rear->sensorLabel = "REAR";
  for (const auto& step : log_.steps) step.scan->timestamp = INVALID_TIMESTAMP;
  Entries entries = asFrames(log_);
  entries.push_back(rear);
  entries.insert(entries.begin(), mrpt::obs::CObservationComment::Create());
  writeGzipped(entries, path("odd.rawlog"));

  const ProgramRun run = slam("odd.rawlog");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  expectOneSentence(run);  // it names the scanner that was chosen
  EXPECT_NE(run.errors.find("--sensor"), std::string::npos);
  expectTruePath(2e-3, degToRad(0.05));

  EXPECT_EQ(slam("odd.rawlog", "--sensor REAR").exitCode, 0);
  EXPECT_EQ(trajectory().size(), 1u);
  EXPECT_EQ(slam("odd.rawlog", "--sensor LEFT").exitCode, 3);
}

TEST_F(PsmksSlam, WhatWasReadBeforeTheDamageIsSaved)
{
  writePlain(asFrames(log_), path("cut.rawlog"));
  const auto bytes = std::filesystem::file_size(path("cut.rawlog"));
  std::filesystem::resize_file(path("cut.rawlog"), 6 * bytes / 10);
  const ProgramRun run = slam("cut.rawlog");
  EXPECT_EQ(run.exitCode, 2);
  expectOneSentence(run);
  EXPECT_EQ(trajectory().size(), 4u);
  EXPECT_NE(summary()["log"]["damage"], "");
}

TEST_F(PsmksSlam, EmptyRandomMissingAndScanlessLogsEndWithTheirExitCodes)
{
  std::ofstream(path("empty.rawlog")).close();
  std::ofstream(path("random.rawlog"), std::ios::binary) << std::string(5000, '\xC3');
  Entries actions;
  for (const auto& step : log_.steps) actions.push_back(makeActions(step));
  writeGzipped(actions, path("scanless.rawlog"));
  const std::pair<const char*, int> expected[] = {
      {"empty.rawlog", 2}, {"random.rawlog", 2}, {"none.rawlog", 2}, {"scanless.rawlog", 3}};
  for (const auto& [name, code] : expected)
  {
    const ProgramRun run = slam(name);
    EXPECT_EQ(run.exitCode, code) << name;
    expectOneSentence(run);
  }
}

TEST_F(PsmksSlam, ScansWithoutAValidRayAreNoUsableScans)
{
  for (const auto& step : log_.steps) step.scan->resizeScanAndAssign(361, 0, false);
  writeGzipped(asFrames(log_), path("blind.rawlog"));
  const ProgramRun run = slam("blind.rawlog");
  EXPECT_EQ(run.exitCode, 3);
  expectOneSentence(run);
}

TEST_F(PsmksSlam, WhereEveryMatchFailsTheOdometryIsSaved)
{
  for (std::size_t i = 1; i < log_.steps.size(); ++i)
    log_.steps[i].scan->resizeScanAndAssign(361, 0, false);
  writeGzipped(asFrames(log_), path("blind.rawlog"));
  const ProgramRun run = slam("blind.rawlog");
  EXPECT_EQ(run.exitCode, 4);
  expectOneSentence(run);
  EXPECT_EQ(trajectory().size(), log_.steps.size());
  EXPECT_TRUE(isNearly(trajectory().back().pose, log_.steps.back().T_odom_robot, 1e-6, 1e-6));
}

TEST_F(PsmksSlam, HelpAndVersionGoToStdout)
{
  const ProgramRun help = run("--help");
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_NE(help.output.find("--ground-truth"), std::string::npos);
  EXPECT_EQ(run("--version").exitCode, 0);
  EXPECT_EQ(run("--version").output.rfind("psmks-slam 0.", 0), 0u);
}

TEST_F(PsmksSlam, WrongCommandLinesEndWithOneSentence)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  std::ofstream(path("foreign.ini")) << "[ICP]\nmaxIterations = 3\n";
  std::ofstream(path("wrong.ini")) << "[psmks.segmentation]\nmin_ray = 6\n";
  const std::pair<const char*, const char*> expected[] = {
      {"", "LOG"},
      {"room.rawlog --no-such-flag", "--no-such-flag"},
      {"room.rawlog --matcher csm", "csm"},
      {"room.rawlog --reference newest", "newest"},
      {"room.rawlog --set segmentation.min_rays=abc", "min_rays"},
      {"room.rawlog --set reference.max_failures=0", "max_failures"},
      {"room.rawlog --set nonsense", "nonsense"},
      {"room.rawlog --config none.ini", "none.ini"},
      {"room.rawlog --config foreign.ini", "foreign.ini"},
      {"room.rawlog --config wrong.ini", "min_rays"},
      {"room.rawlog --carmen-stamps clock", "clock"},
      {"room.rawlog --carmen-fov_deg 400", "fov_deg"}};
  for (const auto& [arguments, word] : expected)
  {
    const ProgramRun result = run(std::string(arguments) + " --output out");
    EXPECT_EQ(result.exitCode, 1) << arguments;
    expectOneSentence(result);
    EXPECT_NE(result.errors.find(word), std::string::npos) << arguments << ": " << result.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(PsmksSlam, TheViewNeedsADisplay)
{
  writeGzipped(asFrames(log_), path("room.rawlog"));
  expectError(run("room.rawlog --view", "env -u DISPLAY"), 1, {"--view"});
}

TEST_F(PsmksSlam, ThePrintedConfigurationIsReadBackAndFlagsOverrideIt)
{
  const std::string printed =
      run("--print-config --set odometry.min_sigma_m=0.02 --reference keyframe").output;
  EXPECT_NE(printed.find("[slam.odometry]"), std::string::npos);
  std::ofstream(path("effective.ini")) << printed;
  EXPECT_EQ(run("--print-config --config effective.ini").output, printed);
  const std::string overridden =
      run("--print-config --config effective.ini --reference sequential").output;
  EXPECT_NE(overridden.find("choice = sequential"), std::string::npos);
  EXPECT_NE(overridden.find("min_sigma_m = 0.02"), std::string::npos);
}

TEST_F(PsmksSlam, TheSenaLoopIsPosedScanByScanIntoASharpMap)
{
  if (!std::filesystem::exists(kSena)) GTEST_SKIP() << kSena << " is not installed";
  const ProgramRun result = run(quoted(kSena) + " --output out");
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  for (const char* name : kResults) EXPECT_GT(std::filesystem::file_size(path("out/") + name), 0u);
  EXPECT_EQ(trajectory().size(), 225u);
  EXPECT_EQ(summary()["scans"], 225);
  EXPECT_LE(summary()["occupied_cells_5cm"], 10500);

  ASSERT_EQ(run(quoted(kSena) + " --output odo --matcher odometry").exitCode, 0);
  const json odometry = json::parse(fileText(path("odo/summary.json")));
  EXPECT_NEAR(odometry["occupied_cells_5cm"], 29400, 200);
}
}  // namespace
}  // namespace psmks
