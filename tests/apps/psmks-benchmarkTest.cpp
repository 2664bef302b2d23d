/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>
#include <tests/support/Program.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace psmks
{
namespace
{
const std::string kProgram = "'" PSMKS_PROGRAM "' ";
constexpr int kPairs = 3;

/** Two scans of the simulated room, 20 cm and 5 degrees apart. */
ScanPair roomPair(int id, std::mt19937_64& random)
{
  const World world = World::smallRoom();
  const Pose2 T_world_ref = world.randomFreePose(0.8, random);
  ScanPair pair;
  pair.id = id;
  pair.T_ref_cur_true = {0.2, 0, degToRad(5)};
  pair.T_ref_cur_odometry = {0.22, 0.01, degToRad(5.5)};
  pair.reference = castScan(world, T_world_ref, LaserOptions(), random).scan;
  pair.current = castScan(world, T_world_ref * pair.T_ref_cur_true, LaserOptions(), random).scan;
  return pair;
}

class PsmksBenchmark : public testing::Test
{
 protected:
  void SetUp() override
  {
    folder_ = testing::TempDir() + "psmks-benchmark_" +
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    pairs_ = path("room.pairs.gz");
    PairsWriter writer(pairs_, {LaserOptions().grid, LaserOptions().maxRange_m, kPairs});
    std::mt19937_64 random(5);
    for (int id = 0; id < kPairs; ++id) writer.write(roomPair(id, random));
    writer.close();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  std::string folder_, pairs_;
};

std::vector<std::string> lines(const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}
}  // namespace

TEST_F(PsmksBenchmark, PrintsATableWithARowForEachMatcherAndGuess)
{
  const ProgramRun run = runProgram(kProgram + "pairs " + pairs_ + " --matchers psmks,guess");
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  // machine, blank, title, heading, 2 matchers x 2 guesses
  ASSERT_EQ(lines(run.output).size(), 8U) << run.output;
  EXPECT_EQ(lines(run.output)[2], "room");
}

TEST_F(PsmksBenchmark, DumpsOneRowForEachPairAndMatcher)
{
  const ProgramRun run =
      runProgram(kProgram + "pairs " + pairs_ + " --matchers psmks,guess --guess zero --dump " +
                 path("dump.csv"));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  const auto rows = lines(fileText(path("dump.csv")));
  ASSERT_EQ(rows.size(), 1U + 2 * kPairs);
  EXPECT_EQ(rows[0],
            "id,matcher,guess,status,x_m,y_m,phi_deg,sigma_x_m,sigma_y_m,sigma_phi_deg,error_m,"
            "error_deg,time_ms");
  EXPECT_EQ(rows[1].rfind("0,psmks,zero,Converged,", 0), 0U) << rows[1];
  EXPECT_EQ(rows[1 + kPairs].rfind("0,guess,zero,Converged,0,0,0,1,1,30,0.2,5,", 0), 0U)
      << rows[1 + kPairs];
}

TEST_F(PsmksBenchmark, PsmksFindsTheMotionOfTheRoomPairs)
{
  const ProgramRun run = runProgram(kProgram + "pairs " + pairs_ +
                                    " --matchers psmks --guess zero --json " + path("t.json"));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  const auto json = nlohmann::json::parse(fileText(path("t.json")));
  const auto& row = json.at("tables").at(0).at("rows").at(0);
  EXPECT_EQ(row.at("success_percent"), 100);
  EXPECT_LT(row.at("translation_median_mm"), 10);
}

TEST_F(PsmksBenchmark, WritesTheTablesInEveryFormat)
{
  const ProgramRun run =
      runProgram(kProgram + "pairs " + pairs_ + " --matchers guess --csv " + path("t.csv") +
                 " --json " + path("t.json") + " --markdown " + path("t.md"));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(lines(fileText(path("t.csv"))).at(1).rfind("room,guess,zero,0,200,", 0), 0U);
  EXPECT_EQ(lines(fileText(path("t.md"))).at(0), "### room");
  const auto json = nlohmann::json::parse(fileText(path("t.json")));
  EXPECT_EQ(json.at("tables").at(0).at("rows").size(), 2U);
  EXPECT_TRUE(json.at("tables").at(0).at("rows").at(0).at("nees_mean").is_null());
}

TEST_F(PsmksBenchmark, ReadsNoMorePairsThanAskedFor)
{
  runProgram(kProgram + "pairs " + pairs_ + " --matchers guess --guess zero --max-pairs 2 --dump " +
             path("dump.csv"));
  EXPECT_EQ(lines(fileText(path("dump.csv"))).size(), 1U + 2);
}

TEST_F(PsmksBenchmark, OptionsReachTheMatcher)
{
  const ProgramRun run =
      runProgram(kProgram + "pairs " + pairs_ +
                 " --matchers psmks --guess zero --set preprocessing.max_range_m=0.1 --dump " +
                 path("dump.csv"));
  EXPECT_EQ(run.exitCode, 4) << "no ray is below 10 cm, so every match fails: " << run.output;
  EXPECT_EQ(fileText(path("dump.csv")).find("Converged"), std::string::npos);
}

TEST_F(PsmksBenchmark, WhatCannotBeAcceptedIsAUsageError)
{
  const auto expectUsageError = [this](const std::string& flags, const std::string& sentence)
  {
    const ProgramRun run = runProgram(kProgram + "pairs " + pairs_ + " " + flags);
    EXPECT_EQ(run.exitCode, 1) << flags;
    EXPECT_EQ(lines(run.errors).size(), 1U) << run.errors;
    EXPECT_NE(run.errors.find(sentence), std::string::npos) << run.errors;
  };
  expectUsageError("--matchers nobody", "matcher 'nobody' is not known, allowed: psmks | ");
  expectUsageError("--guess wild", "'wild' is not known, allowed: zero | odometry");
  expectUsageError("--set joint.nothing=1", "'nothing'");
  expectUsageError("--set nonsense", "'nonsense' is not SECTION.KEY=VALUE");
  expectUsageError("--config absent.ini", "'absent.ini' is no file");
  expectUsageError("--csv /absent/t.csv", "'/absent/t.csv' cannot be created");
}

TEST_F(PsmksBenchmark, AMissingOrForeignFileIsAnInputError)
{
  std::ofstream(path("foreign.pairs")) << "something else\n";
  for (const std::string& name : {path("absent.pairs"), path("foreign.pairs")})
  {
    const ProgramRun run = runProgram(kProgram + "pairs " + name);
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(lines(run.errors).size(), 1U) << run.errors;
    EXPECT_NE(run.errors.find(name), std::string::npos) << run.errors;
  }
}

TEST_F(PsmksBenchmark, WhatWasReadBeforeTheDamageIsProcessed)
{
  const std::string whole = path("whole.pairs"), cut = path("cut.pairs");
  PairsWriter writer(whole, {LaserOptions().grid, LaserOptions().maxRange_m, kPairs});
  std::mt19937_64 random(5);
  for (int id = 0; id < kPairs; ++id) writer.write(roomPair(id, random));
  writer.close();
  const std::string text = fileText(whole);
  std::ofstream(cut, std::ios::binary) << text.substr(0, text.size() - 500);

  const ProgramRun run = runProgram(kProgram + "pairs " + cut +
                                    " --matchers guess --guess zero --dump " + path("dump.csv"));
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(lines(run.errors).size(), 1U) << run.errors;
  EXPECT_EQ(lines(fileText(path("dump.csv"))).size(), 1U + kPairs - 1);
}

TEST_F(PsmksBenchmark, AFileWithoutPairsIsNothingToDo)
{
  PairsWriter(path("empty.pairs"), {LaserOptions().grid, LaserOptions().maxRange_m, 0}).close();
  EXPECT_EQ(runProgram(kProgram + "pairs " + path("empty.pairs")).exitCode, 3);
}

TEST_F(PsmksBenchmark, SegmentationIsTheSameForTheSameSeed)
{
  const auto figures = [this](const std::string& flags)
  {
    const ProgramRun run =
        runProgram(kProgram + "segmentation --poses 20 --csv " + path("s.csv") + " " + flags);
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    std::string rowsWithoutTime;
    for (const auto& row : lines(fileText(path("s.csv"))))
      rowsWithoutTime += row.substr(0, row.rfind(',')) + '\n';
    return rowsWithoutTime;
  };
  EXPECT_EQ(figures("--seed 3"), figures("--seed 3"));
  EXPECT_NE(figures("--seed 3"), figures("--seed 4"));
  EXPECT_EQ(lines(figures("--filter linear")).size(), 1U + 2);
}

TEST_F(PsmksBenchmark, HelpEndsWell)
{
  EXPECT_EQ(runProgram(kProgram + "--help").exitCode, 0);
  EXPECT_EQ(runProgram(kProgram + "pairs --help").exitCode, 0);
  EXPECT_EQ(runProgram(kProgram).exitCode, 1);
}
}  // namespace psmks
