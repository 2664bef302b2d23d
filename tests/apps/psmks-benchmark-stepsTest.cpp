/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/apps/BenchmarkOnLogs.h>
#include <tests/support/Says.h>

#include <sstream>

namespace psmks
{
namespace
{
using namespace test;

class PsmksBenchmarkSteps : public BenchmarkOnLogs
{
};

class PsmksBenchmarkSelfmatch : public BenchmarkOnLogs
{
 protected:
  /** The columns error_m and error_deg of the CSV file of all matches. */
  std::vector<std::pair<double, double>> dumpedErrors(const std::string& name) const
  {
    std::vector<std::pair<double, double>> errors;
    std::istringstream lines(fileText(path(name)));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
    {
      std::istringstream cells(line);
      std::vector<std::string> values;
      for (std::string cell; std::getline(cells, cell, ',');) values.push_back(cell);
      errors.emplace_back(std::stod(values.at(10)), std::stod(values.at(11)));
    }
    return errors;
  }
};
}  // namespace

TEST_F(PsmksBenchmarkSteps, EveryMatcherStartsFromEveryGuess)
{
  writeTruth("room.reference.tum");
  const ProgramRun done = run("steps " + log("room") + " --matchers psmks,guess");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  EXPECT_EQ(table().at("table"), "room every 1: 7 pairs");
  ASSERT_EQ(rows().size(), 4U);
  for (const std::size_t psmks : {0U, 2U})
  {
    EXPECT_EQ(rows()[psmks].at("success_percent"), 100);
    EXPECT_LT(rows()[psmks].at("translation_median_mm"), 2);
    EXPECT_LT(rows()[psmks].at("rotation_median_deg"), 0.1);
  }
  EXPECT_EQ(rows()[1].at("guess"), "zero");
  EXPECT_NEAR(rows()[1].at("rotation_median_deg"), 5, 1e-3) << "what a step turns";
  EXPECT_EQ(rows()[3].at("guess"), "odometry");
  EXPECT_NEAR(rows()[3].at("rotation_median_deg"), 1, 1e-3) << "what it turns too little";
}

//   o . o . o . o .     every second scan is kept: three motions of two steps each
TEST_F(PsmksBenchmarkSteps, ScansBetweenCanBeLeftOut)
{
  writeTruth("room.gt.tum");
  const std::string flags = "steps " + log("room") + " --matchers guess --guess zero";
  ASSERT_EQ(run(flags + " --every 2,7,8").exitCode, 0);
  EXPECT_EQ(table(0).at("table"), "room every 2: 3 pairs");
  EXPECT_NEAR(rows(0)[0].at("rotation_median_deg"), 10, 1e-3);
  EXPECT_EQ(table(1).at("table"), "room every 7: 1 pairs");
  EXPECT_NEAR(rows(1)[0].at("rotation_median_deg"), 35, 1e-3);
  EXPECT_THROW(table(2), nlohmann::json::exception) << "no pairs, no table";
  ASSERT_EQ(run(flags + " --skip-scans 1").exitCode, 0);
  EXPECT_EQ(table().at("table"), "room every 1: 6 pairs");
}

TEST_F(PsmksBenchmarkSteps, TheLimitsOfASuccessCanBeMoved)
{
  writeTruth("room.gt.tum");
  const auto success_percent = [this](const std::string& limits)
  {
    run("steps " + log("room") + " --matchers guess --guess zero" + limits);
    return rows()[0].at("success_percent").get<double>();
  };
  EXPECT_EQ(success_percent(""), 0) << "5 degrees are more than 2";
  EXPECT_EQ(success_percent(" --success_deg 6"), 100);
  EXPECT_EQ(success_percent(" --success_deg 6 --success_m 0.05"), 0);
}

/** After half a turn the robot sees nothing of what it saw before. */
TEST_F(PsmksBenchmarkSteps, PairsThatShareTooLittleAreLeftOutAndCounted)
{
  RoomLog turned(3);
  turned.steps[2].T_world_robot = {0, 0, kPi};
  Scanner scanner;
  scanner.aperture_rad = kPi / 2;
  for (std::size_t i = 0; i < 3; ++i)
  {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create(
        observe(officeRoom(), toMrpt(turned.steps[i].T_world_robot), scanner));
    scan->timestamp = turned.steps[i].scan->timestamp;
    turned.steps[i].scan = scan;
  }
  writeGzipped(asFrames(turned), log("turned"));
  Trajectory truth;
  for (const auto& step : turned.steps) truth.push_back({step.stamp_s, step.T_world_robot});
  std::ofstream out(path("turned.gt.tum"));
  writeTum(out, truth);
  out.close();

  ASSERT_EQ(run("steps " + log("turned") + " --matchers guess").exitCode, 0);
  EXPECT_EQ(table().at("table"), "turned every 1: 1 pairs; 1 left out that share too little");
}

TEST_F(PsmksBenchmarkSteps, PairsWithoutATruthAreLeftOutAndCounted)
{
  std::ofstream out(path("room.gt.tum"));
  writeTum(out, {{log_.steps[0].stamp_s, log_.steps[0].T_world_robot},
                 {log_.steps[1].stamp_s, log_.steps[1].T_world_robot}});
  out.close();
  ASSERT_EQ(run("steps " + log("room") + " --matchers guess").exitCode, 0);
  EXPECT_EQ(table().at("table"), "room every 1: 1 pairs; 6 left out without a truth");
}

TEST_F(PsmksBenchmarkSteps, WithoutATruthThereIsNothingToDo)
{
  const ProgramRun done = run("steps " + log("room") + " --matchers guess");
  EXPECT_EQ(done.exitCode, 3);
  EXPECT_TRUE(says(done.errors, {"'room' has no true trajectory"}));
}

TEST_F(PsmksBenchmarkSteps, WhatCannotBeAcceptedIsAUsageError)
{
  const std::string room = "steps " + log("room");
  expectUsageError(room + " --matchers nobody", "matcher 'nobody' is not known");
  expectUsageError(room + " --every 0", "--every");
  expectUsageError(room + " --guess wild", "wild");
  expectUsageError(room + " --success_m 0", "--success_m");
  expectUsageError(room + " --set joint.nothing=1", "'nothing'");
  expectUsageError(room + " " + log("room") + " --ground-truth t.tum", "belongs to one LOG");
}

TEST_F(PsmksBenchmarkSteps, TheWorstPairsAreDrawnOnAPage)
{
  writeTruth("room.gt.tum");
  ASSERT_EQ(run("steps " + log("room") + " --matchers psmks --html " + path("s.html")).exitCode, 0);
  EXPECT_TRUE(says(fileText(path("s.html")), {"<figcaption>pair 7: ", "room every 1: 7 pairs"}));
}

TEST_F(PsmksBenchmarkSelfmatch, EveryScanFindsItselfAgain)
{
  const ProgramRun done = run("selfmatch " + log("room") + " --matchers psmks,guess");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  EXPECT_EQ(table().at("table"), "room: 8 scans");
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_EQ(rows()[0].at("success_percent"), 100);
  EXPECT_LT(rows()[0].at("translation_median_mm"), 0.1);
  EXPECT_EQ(rows()[1].at("matcher"), "guess");
  EXPECT_LT(rows()[1].at("success_percent"), 50);
}

TEST_F(PsmksBenchmarkSelfmatch, GuessesAreWrongByAtMostWhatWasAskedFor)
{
  const std::string dump =
      "selfmatch " + log("room") + " --matchers guess --dump " + path("d.csv") + ' ';
  ASSERT_EQ(run(dump + "--displacement_m 0.2 --rotation_deg 30").exitCode, 0);
  double largest_m = 0, largest_deg = 0;
  ASSERT_EQ(dumpedErrors("d.csv").size(), 8U);
  for (const auto& [error_m, error_deg] : dumpedErrors("d.csv"))
  {
    largest_m = std::max(largest_m, error_m);
    largest_deg = std::max(largest_deg, error_deg);
  }
  EXPECT_LE(largest_m, 0.2);
  EXPECT_GT(largest_m, 0.05);
  EXPECT_LE(largest_deg, 30);
  EXPECT_GT(largest_deg, 7);
  ASSERT_EQ(run(dump + "--displacement_m 0 --rotation_deg 0").exitCode, 0);
  EXPECT_EQ(rows()[0].at("success_percent"), 100);
}

TEST_F(PsmksBenchmarkSelfmatch, TheGuessesAreTheSameForTheSameSeed)
{
  const auto errors = [this](const std::string& seed)
  {
    run("selfmatch " + log("room") + " --matchers guess --dump " + path("d.csv") + " --seed " +
        seed);
    return dumpedErrors("d.csv");
  };
  EXPECT_EQ(errors("3"), errors("3"));
  EXPECT_NE(errors("3"), errors("4"));
}

TEST_F(PsmksBenchmarkSelfmatch, WhatCannotBeAcceptedSaysWhy)
{
  const std::string room = "selfmatch " + log("room");
  expectUsageError(room + " --matchers nobody", "matcher 'nobody' is not known");
  expectUsageError(room + " --displacement_m -1", "--displacement_m");
  expectUsageError(room + " --rotation_deg 181", "--rotation_deg");
  EXPECT_EQ(run("selfmatch " + log("absent")).exitCode, 2);
}
}  // namespace psmks
