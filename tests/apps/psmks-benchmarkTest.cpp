/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>
#include <tests/support/ProgramTest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace psmks
{
namespace
{
constexpr int kPairs = 3;

/** Two scans of the simulated room that are 20 cm and 5 degrees apart. */
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

class PsmksBenchmark : public test::ProgramTest
{
 protected:
  PsmksBenchmark() : ProgramTest(PSMKS_PROGRAM) {}

  void SetUp() override
  {
    PairsWriter writer(pairs_, {LaserOptions().grid, LaserOptions().maxRange_m, kPairs});
    std::mt19937_64 random(5);
    for (int id = 0; id < kPairs; ++id) writer.write(roomPair(id, random));
    writer.close();
  }

  const std::string pairs_ = path("room.pairs.gz");
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
  const ProgramRun done = run("pairs " + pairs_ + " --matchers psmks,guess");
  EXPECT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  // machine, blank, title, heading, (bound and 2 matchers) x 2 guesses
  ASSERT_EQ(lines(done.output).size(), 10U) << done.output;
  EXPECT_EQ(lines(done.output)[2], "room");
  EXPECT_EQ(lines(done.output)[4].rfind("bound ", 0), 0U) << done.output;
}

TEST_F(PsmksBenchmark, DumpsOneRowForEachPairAndMatcher)
{
  const ProgramRun done =
      run("pairs " + pairs_ + " --matchers psmks,guess --guess zero --dump " + path("dump.csv"));
  ASSERT_EQ(done.exitCode, 0) << done.errors;
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
  const ProgramRun done =
      run("pairs " + pairs_ + " --matchers psmks --guess zero --json " + path("t.json"));
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const auto json = nlohmann::json::parse(fileText(path("t.json")));
  const auto& rows = json.at("tables").at(0).at("rows");
  ASSERT_EQ(rows.at(1).at("matcher"), "psmks");
  EXPECT_EQ(rows.at(1).at("success_percent"), 100);
  EXPECT_LT(rows.at(1).at("translation_median_mm"), 10);
  EXPECT_NEAR(rows.at(1).at("translation_median_mm").get<double>(),
              rows.at(1).at("translation_median_to_bound").get<double>() *
                  rows.at(0).at("translation_median_mm").get<double>(),
              1e-6);
}

TEST_F(PsmksBenchmark, WritesTheTablesInEveryFormat)
{
  const ProgramRun done = run("pairs " + pairs_ + " --matchers guess --csv " + path("t.csv") +
                              " --json " + path("t.json") + " --markdown " + path("t.md"));
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(lines(fileText(path("t.csv"))).at(1).rfind("room,bound,zero,,", 0), 0U);
  EXPECT_EQ(lines(fileText(path("t.csv"))).at(2).rfind("room,guess,zero,0,200,", 0), 0U);
  EXPECT_EQ(lines(fileText(path("t.md"))).at(0), "### room");
  const auto json = nlohmann::json::parse(fileText(path("t.json")));
  EXPECT_EQ(json.at("tables").at(0).at("rows").size(), 4U);
  EXPECT_TRUE(json.at("tables").at(0).at("rows").at(1).at("nees_mean").is_null());
}

TEST_F(PsmksBenchmark, ReadsNoMorePairsThanAskedFor)
{
  run("pairs " + pairs_ + " --matchers guess --guess zero --max-pairs 2 --dump " +
      path("dump.csv"));
  EXPECT_EQ(lines(fileText(path("dump.csv"))).size(), 1U + 2);
}

TEST_F(PsmksBenchmark, OptionsReachTheMatcher)
{
  const ProgramRun done =
      run("pairs " + pairs_ +
          " --matchers psmks --guess zero --set preprocessing.max_range_m=0.1 --dump " +
          path("dump.csv"));
  EXPECT_EQ(done.exitCode, 4) << "no ray is below 10 cm, so every match fails: " << done.output;
  EXPECT_EQ(fileText(path("dump.csv")).find("Converged"), std::string::npos);
}

TEST_F(PsmksBenchmark, WhatCannotBeAcceptedIsAUsageError)
{
  const auto expectUsageError = [this](const std::string& flags, const std::string& sentence)
  {
    const ProgramRun done = run("pairs " + pairs_ + " " + flags);
    EXPECT_EQ(done.exitCode, 1) << flags;
    EXPECT_EQ(lines(done.errors).size(), 1U) << done.errors;
    EXPECT_NE(done.errors.find(sentence), std::string::npos) << done.errors;
  };
  expectUsageError("--matchers nobody", "matcher 'nobody' is not known, allowed: psmks | ");
  expectUsageError("--guess wild", "wild not in");
  expectUsageError("--set joint.nothing=1", "'nothing'");
  expectUsageError("--set nonsense", "'nonsense' is not SECTION.KEY=VALUE");
  expectUsageError("--config absent.ini", "'absent.ini': no such file");
  expectUsageError("--sensor-file lost.ini", "'lost.ini': no such file");
  expectUsageError("--csv /absent/t.csv", "'/absent/t.csv' cannot be created");
}

TEST_F(PsmksBenchmark, AMissingOrForeignFileIsAnInputError)
{
  std::ofstream(path("foreign.pairs")) << "something else\n";
  for (const std::string& name : {path("absent.pairs"), path("foreign.pairs")})
  {
    const ProgramRun done = run("pairs " + name);
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_EQ(lines(done.errors).size(), 1U) << done.errors;
    EXPECT_NE(done.errors.find(name), std::string::npos) << done.errors;
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

  const ProgramRun done =
      run("pairs " + cut + " --matchers guess --guess zero --dump " + path("dump.csv"));
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_EQ(lines(done.errors).size(), 1U) << done.errors;
  EXPECT_EQ(lines(fileText(path("dump.csv"))).size(), 1U + kPairs - 1);
}

TEST_F(PsmksBenchmark, AFileWithoutPairsIsNothingToDo)
{
  PairsWriter(path("empty.pairs"), {LaserOptions().grid, LaserOptions().maxRange_m, 0}).close();
  EXPECT_EQ(run("pairs " + path("empty.pairs")).exitCode, 3);
}

/** The rows of tables in CSV without the columns that depend on the machine. */
std::vector<std::string> rowsWithoutTimes(const std::string& csv)
{
  constexpr int kTimes = 5;  // columns at the end
  std::vector<std::string> rows = lines(csv);
  for (std::string& row : rows)
    for (int i = 0; i < kTimes; ++i) row.erase(row.rfind(','));
  return rows;
}

TEST_F(PsmksBenchmark, GeneratesSetsByNameAndSeed)
{
  const auto figures = [this](const std::string& flags)
  {
    const ProgramRun done =
        run("pairs fov90 corridor --pairs 5 --matchers psmks --csv " + path("t.csv") + flags);
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return rowsWithoutTimes(fileText(path("t.csv")));
  };
  const auto rows = figures(" --seed 3");
  EXPECT_EQ(rows, figures(" --seed 3"));
  EXPECT_NE(rows, figures(" --seed 4"));
  // heading, (bound and psmks) x 2 guesses for each set and for both as one
  ASSERT_EQ(rows.size(), 1U + 3 * 4);
  EXPECT_EQ(rows[1].rfind("fov90,bound,zero,", 0), 0U) << rows[1];
  EXPECT_EQ(rows[6].rfind("corridor,psmks,zero,", 0), 0U) << rows[6];
  EXPECT_EQ(rows[9].rfind("all sets without moving objects,bound,zero,", 0), 0U) << rows[9];
}

TEST_F(PsmksBenchmark, ASetWithPeopleIsLeftOutOfTheTableOfAllSets)
{
  const auto tables = [this](const std::string& sets)
  {
    const ProgramRun done =
        run("pairs " + sets + " --pairs 4 --matchers guess --guess zero --csv " + path("t.csv"));
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return rowsWithoutTimes(fileText(path("t.csv")));
  };
  const auto without = tables("L180_small fov90"), with = tables("L180_small people fov90");
  ASSERT_EQ(without.size(), 1U + 3 * 2);
  ASSERT_EQ(with.size(), 1U + 4 * 2);
  EXPECT_EQ(with.back(), without.back());
  EXPECT_EQ(with.back().rfind("all sets without moving objects,guess,", 0), 0U) << with.back();
  EXPECT_EQ(tables("L180_small people").size(), 1U + 2 * 2);
}

TEST_F(PsmksBenchmark, SavedPairsGiveTheSameTableAgain)
{
  const std::string flags = " --matchers psmks --csv " + path("t.csv");
  const ProgramRun saving = run("pairs quantised --pairs 5 --save-pairs " + path("saved") + flags);
  ASSERT_EQ(saving.exitCode, 0) << saving.errors;
  const auto rows = rowsWithoutTimes(fileText(path("t.csv")));
  const ProgramRun reading = run("pairs " + path("saved/quantised.pairs.gz") + flags);
  ASSERT_EQ(reading.exitCode, 0) << reading.errors;
  EXPECT_EQ(rowsWithoutTimes(fileText(path("t.csv"))), rows);

  const ProgramRun again = run("pairs quantised --save-pairs " + path("saved") + flags);
  EXPECT_EQ(again.exitCode, 1);
  EXPECT_NE(again.errors.find("exists already"), std::string::npos) << again.errors;
}

TEST_F(PsmksBenchmark, TheBoundOfAFileGrowsWithTheNoiseThatIsStated)
{
  const auto bound_mm = [this](const std::string& flags)
  {
    run("pairs " + pairs_ + " --matchers guess --guess zero --json " + path("t.json") + flags);
    const auto json = nlohmann::json::parse(fileText(path("t.json")));
    return json.at("tables").at(0).at("rows").at(0).at("translation_median_mm").get<double>();
  };
  EXPECT_DOUBLE_EQ(bound_mm(""), bound_mm(" --range-sigma_m 0.01"));
  EXPECT_GT(bound_mm(" --range-sigma_m 0.02"), 1.5 * bound_mm(""));
}

TEST_F(PsmksBenchmark, ListsTheSetsThatCanBeGenerated)
{
  const ProgramRun done = run("pairs --list-sets");
  EXPECT_EQ(done.exitCode, 0);
  EXPECT_EQ(lines(done.output).at(0).rfind("L180_small ", 0), 0U) << done.output;
  EXPECT_NE(done.output.find("\ncurved "), std::string::npos);
}

TEST_F(PsmksBenchmark, AnUnknownSetIsAUsageErrorThatNamesTheKnownOnes)
{
  const ProgramRun done = run("pairs curved moon");
  EXPECT_EQ(done.exitCode, 1);
  EXPECT_EQ(lines(done.errors).size(), 1U) << done.errors;
  EXPECT_NE(done.errors.find("'moon'"), std::string::npos) << done.errors;
  EXPECT_NE(done.errors.find("L180_small, "), std::string::npos) << done.errors;
  EXPECT_EQ(run("pairs").exitCode, 1);
}

TEST_F(PsmksBenchmark, SegmentationIsTheSameForTheSameSeed)
{
  const auto figures = [this](const std::string& flags)
  {
    const ProgramRun done = run("segmentation --poses 20 --csv " + path("s.csv") + " " + flags);
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    std::string rowsWithoutTime;
    for (const auto& row : lines(fileText(path("s.csv"))))
      rowsWithoutTime += row.substr(0, row.rfind(',')) + '\n';
    return rowsWithoutTime;
  };
  EXPECT_EQ(figures("--seed 3"), figures("--seed 3"));
  EXPECT_NE(figures("--seed 3"), figures("--seed 4"));
  EXPECT_EQ(lines(figures("--filter linear")).size(), 1U + 2);
}

// The experiments of the paper.

/** The files below a folder, by their paths relative to it. */
std::set<std::string> filesIn(const std::string& folder)
{
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.insert(std::filesystem::relative(entry.path(), folder).string());
  return files;
}

/** The pictures that a Markdown text links to. */
std::vector<std::string> pictureLinks(const std::string& markdown)
{
  const std::regex picture(R"(!\[[^\]]*\]\(([^)]+)\))");
  std::vector<std::string> links;
  for (std::sregex_iterator i(markdown.begin(), markdown.end(), picture), none; i != none; ++i)
    links.push_back((*i)[1].str());
  return links;
}

TEST_F(PsmksBenchmark, ExperimentsWriteAReportWithItsTablesAndPictures)
{
  const ProgramRun done =
      run("experiments --quick --minutes 0.2 --worlds room --methods paper,joint-map --output " +
          path("report"));
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const std::string report = fileText(path("report/experiments.md"));
  int tables = 0;
  for (const auto& line : lines(report)) tables += line.rfind("|--", 0) == 0 ? 1 : 0;
  EXPECT_EQ(tables, 5) << report;
  for (const char* method : {"| paper |", "| joint map |"})
    EXPECT_NE(report.find(method), std::string::npos) << method << " in " << report;
  EXPECT_EQ(report.find("| MRPT ICP |"), std::string::npos);

  const auto links = pictureLinks(report);
  EXPECT_EQ(links.size(), hasGnuplot() ? 3U : 0U);  // paths, maps, orientation search
  for (const auto& link : links)
    EXPECT_GT(std::filesystem::file_size(path("report/" + link)), 1000U) << link;
}

TEST_F(PsmksBenchmark, ExperimentsInAHurryWriteNoFile)
{
  const auto before = filesIn(path("."));
  const ProgramRun done =
      run("experiments --quick --minutes 0.1 --worlds room,office --methods joint-keyframe");
  EXPECT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(filesIn(path(".")), before);
  for (const char* world : {"room", "office"})
    EXPECT_NE(done.output.find(world), std::string::npos) << done.output;
}

TEST_F(PsmksBenchmark, ExperimentsAreTheSameForTheSameSeed)
{
  const auto table = [this](const std::string& flags)
  {
    const ProgramRun done =
        run("experiments --quick --minutes 0.1 --worlds clutter --methods joint-map "
            "--csv " +
            path("e.csv") + " " + flags);
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return fileText(path("e.csv"));
  };
  EXPECT_EQ(table("--first-seed 3"), table("--first-seed 3"));
  EXPECT_NE(table("--first-seed 3"), table("--first-seed 4"));
}

TEST_F(PsmksBenchmark, ExperimentsWithAnUnknownWordAreAUsageError)
{
  const auto expectUsageError = [this](const std::string& flags, const std::string& word)
  {
    const ProgramRun done = run("experiments --quick " + flags);
    EXPECT_EQ(done.exitCode, 1) << flags;
    EXPECT_NE(done.errors.find(word), std::string::npos) << done.errors;
  };
  expectUsageError("--worlds moon", "moon");
  expectUsageError("--methods guessing", "guessing");
  expectUsageError("--ranges_m -1", "--ranges_m");
  expectUsageError("--seeds 0", "--seeds");
  expectUsageError("--set joint.nothing=1", "'nothing'");
}

TEST_F(PsmksBenchmark, HelpEndsWell)
{
  EXPECT_EQ(run("--help").exitCode, 0);
  EXPECT_EQ(run("pairs --help").exitCode, 0);
  EXPECT_EQ(run("").exitCode, 1);
}
}  // namespace psmks
