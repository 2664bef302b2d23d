/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <fcntl.h>
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <sys/file.h>
#include <tests/support/ProgramTest.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Says.h>
#include <tests/unit/logs/RoomLog.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using namespace test;
namespace fs = std::filesystem;
using nlohmann::json;

const char* const kResults[] = {"trajectory.tum", "odometry.tum", "matches.csv",   "graph.g2o",
                                "map.pgm",        "map.yaml",     "segments.csv",  "map.svg",
                                "map.png",        "map.3Dscene",  "map.simplemap", "summary.json"};

/** Faults of the machine that psmks-slam runs on. */
class PsmksSlamFaults : public test::ProgramTest
{
 protected:
  PsmksSlamFaults() : ProgramTest(PSMKS_PROGRAM) {}

  ProgramRun slam(const std::string& flags = "", const std::string& prefix = "") const
  {
    return run("room.rawlog --output out " + flags, prefix);
  }

  /** Writes the log of a drive in a circle, round after round. */
  void writeRounds(int rounds) const
  {
    constexpr int kScansOfARound = 72;  // of 5 degrees
    const RoomLog log(kScansOfARound);
    mrpt::io::CFileGZOutputStream file(path("room.rawlog"));
    auto archive = mrpt::serialization::archiveFrom(file);
    double stamp_s = log.steps.front().stamp_s;
    for (int round = 0; round < rounds; ++round)
      for (RoomLog::Step step : log.steps)
      {
        step.stamp_s = stamp_s += 0.25;
        step.scan->timestamp = mrpt::Clock::fromDouble(stamp_s);
        step.odometryIncrement = log.steps.back().odometryIncrement;
        mrpt::obs::CSensoryFrame frame;
        frame.insert(step.scan);
        archive << *makeActions(step) << frame;
      }
  }

  void writeRoom() const { writeGzipped(asFrames(RoomLog(8)), path("room.rawlog")); }

  std::size_t poses() const { return readTrajectory(path("out/trajectory.tum")).size(); }

  /** Expects all results whole and nothing else, or no folder. */
  void expectAllOrNothing(const std::string& what) const
  {
    if (!fs::exists(path("out"))) return;
    const auto files = std::distance(fs::directory_iterator(path("out")), fs::directory_iterator());
    EXPECT_EQ(files, std::distance(std::begin(kResults), std::end(kResults))) << what;
    for (const char* name : kResults) EXPECT_GT(fs::file_size(path("out/") + name), 0u) << what;
    const json summary = json::parse(fileText(path("out/summary.json")));
    EXPECT_EQ(summary["scans"], poses()) << what;
  }
};

TEST_F(PsmksSlamFaults, ASignalStopsTheRunAndSavesWhatWasDone)
{
  writeRounds(60);
  RandomNumbers random(31);
  SCOPED_TRACE(random.seedText());
  std::size_t saved = 0;
  for (const auto& [signal, exitCode] :
       {std::pair{"INT", 130}, {"TERM", 143}, {"HUP", 129}, {"INT", 130}, {"TERM", 143}})
  {
    fs::remove_all(path("out"));
    const std::string seconds = std::to_string(random.uniform(0.05, 1.0));
    const std::string what = std::string(signal) + " after " + seconds + " s";
    const ProgramRun run =
        slam("", "timeout --preserve-status -s " + std::string(signal) + ' ' + seconds);
    EXPECT_EQ(run.exitCode, exitCode) << what << run.errors;
    expectAllOrNothing(what);
    if (!fs::exists(path("out"))) continue;
    saved += poses();
    EXPECT_TRUE(says(run.errors, {"psmks-slam: stopped by SIG" + std::string(signal)})) << what;
  }
  EXPECT_GT(saved, 0u);
}

TEST_F(PsmksSlamFaults, AnOutputThatCannotBeWrittenStopsNoOther)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  writeRoom();
  for (const char* full : kResults)
  {
    fs::remove_all(path("out"));
    fs::create_directory(path("out"));
    fs::create_symlink("/dev/full", path("out/") + full);
    const ProgramRun run = slam("--overwrite");
    expectError(run, 5, {"cannot write", full});
    for (const char* name : kResults)
    {
      if (std::string(name) == full) continue;
      EXPECT_GT(fs::file_size(path("out/") + name), 0u) << name << " beside " << full;
    }
  }
}

TEST_F(PsmksSlamFaults, AFullDiskKeepsTheFilesThatWereThere)
{
  if (geteuid() != 0) GTEST_SKIP() << "only root can mount a small disk";
  writeRoom();
  fs::create_directory(path("out"));
  if (runProgram("mount -t tmpfs -o size=48k none '" + path("out") + "'").exitCode != 0)
    GTEST_SKIP() << "no disk can be mounted here";
  std::ofstream(path("out/map.simplemap")) << "the map of yesterday";
  const ProgramRun run = slam("--overwrite");
  const std::string map = fileText(path("out/map.simplemap"));
  const auto left =
      std::count_if(fs::directory_iterator(path("out")), fs::directory_iterator(),
                    [](const auto& file) { return file.path().filename().string()[0] == '.'; });
  const bool hasTexts = fs::exists(path("out/trajectory.tum"));
  runProgram("umount '" + path("out") + "'");
  expectError(run, 5, {"cannot write"});
  EXPECT_TRUE(hasTexts);
  EXPECT_EQ(left, 0) << "nothing half is left";
  EXPECT_FALSE(map.empty());
}

TEST_F(PsmksSlamFaults, ARawlogAndAnOutputStreamThatAreFullAreTold)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  writeRoom();
  expectError(slam("--save-rawlog /dev/full --overwrite"), 5, {"cannot write '/dev/full'"});
  expectAllOrNothing("the rawlog is full");
  const ProgramRun run = runProgram("cd '" + path("") + "' && sh -c \"'" + PSMKS_PROGRAM +
                                    "' room.rawlog --output out -w 2>&1 >/dev/full\"");
  EXPECT_EQ(run.exitCode, 5);
  EXPECT_EQ(run.output, "psmks-slam: cannot write to the standard output\n");
}

TEST_F(PsmksSlamFaults, TwoRunsDoNotShareAFolder)
{
  writeRoom();
  fs::create_directory(path("out"));
  const int other = open(path("out").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  expectError(slam("--overwrite"), 1, {"'out' is in use by another run"});
  close(other);
  EXPECT_EQ(slam("--overwrite").exitCode, 0);
}

TEST_F(PsmksSlamFaults, WhereNothingWasDoneNothingIsLeft)
{
  std::ofstream(path("empty.rawlog")).close();
  writeRoom();
  EXPECT_EQ(run("absent.rawlog -o new/out").exitCode, 2);
  EXPECT_FALSE(fs::exists(path("new")));
  EXPECT_EQ(run("empty.rawlog -o out --save-rawlog matched.rawlog").exitCode, 2);
  EXPECT_FALSE(fs::exists(path("out")));
  EXPECT_FALSE(fs::exists(path("matched.rawlog")));
  EXPECT_EQ(run("room.rawlog -s absent -o out").exitCode, 3);
  EXPECT_FALSE(fs::exists(path("out")));
  fs::create_directory(path("mine"));
  EXPECT_EQ(run("absent.rawlog -o mine").exitCode, 2);
  EXPECT_TRUE(fs::exists(path("mine"))) << "was there before";
}

TEST_F(PsmksSlamFaults, ALinkToAFileStaysALink)
{
  writeRoom();
  fs::create_directory(path("out"));
  std::ofstream(path("elsewhere.tum")) << "before\n";
  fs::create_symlink(path("elsewhere.tum"), path("out/trajectory.tum"));
  EXPECT_EQ(slam("--overwrite").exitCode, 0);
  EXPECT_TRUE(fs::is_symlink(path("out/trajectory.tum")));
  EXPECT_EQ(readTrajectory(path("elsewhere.tum")).size(), 8u);
}

TEST_F(PsmksSlamFaults, ALabelThatIsNoTextIsQuotedShortly)
{
  const RoomLog log(8);
  for (const auto& step : log.steps) step.scan->sensorLabel = std::string(100000, '\xFF');
  auto entries = asFrames(log);
  const auto other = mrpt::obs::CObservation2DRangeScan::Create(*log.steps.front().scan);
  other->sensorLabel = "REAR";
  std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entries[1])->insert(other);
  writeGzipped(entries, path("room.rawlog"));
  const ProgramRun run = slam();
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_LT(run.errors.size(), 1000u);
  expectAllOrNothing("label");
}

// A rawlog of eight scans, cut at many places and with single bits flipped.
TEST_F(PsmksSlamFaults, ADamagedRawlogIsUsedUpToItsDamage)
{
  writePlain(asFrames(RoomLog(8)), path("whole.rawlog"));
  const std::string whole = fileText(path("whole.rawlog"));
  RandomNumbers random(32);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 12; ++i)
  {
    std::string damaged = whole;
    const auto at = static_cast<std::size_t>(
        random.integer(static_cast<int>(whole.size() / 2), static_cast<int>(whole.size()) - 1));
    if (i % 2 == 0) damaged.resize(at);
    if (i % 2 == 1) damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.integer(0, 7)));
    std::ofstream(path("room.rawlog"), std::ios::binary) << damaged;
    const ProgramRun run = slam("--overwrite");
    EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 2) << run.exitCode << " byte " << at;
    EXPECT_GE(poses(), 3u) << "byte " << at;
    expectAllOrNothing("byte " + std::to_string(at));
  }
}
}  // namespace
}  // namespace psmks
