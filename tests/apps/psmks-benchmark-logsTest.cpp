/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/apps/BenchmarkOnLogs.h>
#include <tests/support/Says.h>
#include <tests/unit/report/Markup.h>

#include <algorithm>
#include <filesystem>

namespace psmks
{
namespace
{
using namespace test;

class PsmksBenchmarkLogs : public BenchmarkOnLogs
{
 protected:
  ProgramRun run(const std::string& arguments) const
  {
    return BenchmarkOnLogs::run("logs " + arguments);
  }

  /** Writes true motions between scans, which are given by their indices in the log. */
  void writeRelations(const std::vector<std::pair<std::size_t, std::size_t>>& places) const
  {
    std::ofstream out(path("room.relations"));
    out << std::fixed << std::setprecision(9);
    for (const auto& [from, to] : places)
    {
      const auto &a = log_.steps.at(from), &b = log_.steps.at(to);
      const Pose2 T_from_to = a.T_world_robot.inverse() * b.T_world_robot;
      out << a.stamp_s << ' ' << b.stamp_s << ' ' << T_from_to.x_m << ' ' << T_from_to.y_m
          << " 0 0 0 " << T_from_to.phi_rad << '\n';
    }
  }
};
}  // namespace

TEST_F(PsmksBenchmarkLogs, EveryMatcherRunsWithEveryReferenceAndTheOdometryOnce)
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

TEST_F(PsmksBenchmarkLogs, MatchedScansLieSharperOnEachOtherThanTheOdometryLaysThem)
{
  ASSERT_EQ(run(log("room") + " --matchers psmks,guess --references keyframe").exitCode, 0);
  EXPECT_LT(rows()[0].at("occupied_cells_5cm"), rows()[1].at("occupied_cells_5cm"));
  EXPECT_EQ(rows()[0].at("matches"), kScans - 1);
  EXPECT_EQ(rows()[0].at("failed"), 0);
  EXPECT_NEAR(rows()[0].at("path_m"), 0.1 * (kScans - 1), 0.01);
  EXPECT_TRUE(rows()[0].at("error_mean_m").is_null()) << "there is no ground truth";
}

TEST_F(PsmksBenchmarkLogs, TheGroundTruthBesideTheLogIsFound)
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

TEST_F(PsmksBenchmarkLogs, TheGroundTruthOfTheFlagCountsBeforeTheOneBesideTheLog)
{
  writeTruth("room.gt.tum");
  writeTruth("wrong.tum", 0.5);
  ASSERT_EQ(
      run(log("room") + " --matchers psmks --references map --ground-truth " + path("wrong.tum"))
          .exitCode,
      0);
  EXPECT_NEAR(rows()[0].at("error_max_m"), 0.5, 0.02);
}

TEST_F(PsmksBenchmarkLogs, OptionsReachTheMatcherAndTheChoiceOfReferences)
{
  const std::string flags = " --matchers psmks --references sequential --set ";
  EXPECT_EQ(run(log("room") + flags + "preprocessing.max_range_m=0.1").exitCode, 4)
      << "no ray is below 10 cm, so every match fails";
  ASSERT_EQ(run(log("room") + flags + "reference.match_every_scan=false").exitCode, 0);
  EXPECT_LT(rows()[0].at("matches"), kScans - 1) << "most are nearer than the trigger";
}

TEST_F(PsmksBenchmarkLogs, ALogIsCutAtTheScansAskedFor)
{
  ASSERT_EQ(run(log("room") + " --matchers guess --max-scans 3").exitCode, 0);
  EXPECT_EQ(rows()[0].at("scans"), 3);
}

TEST_F(PsmksBenchmarkLogs, EveryLogHasItsTableAndAMissingOneIsToldAtTheEnd)
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

TEST_F(PsmksBenchmarkLogs, ALogWithoutScansIsNothingToDo)
{
  writeGzipped({makeOdometry(log_.steps.front())}, log("blind"));
  const ProgramRun done = run(log("blind") + " --matchers guess");
  EXPECT_EQ(done.exitCode, 3);
  EXPECT_NE(done.errors.find("holds no usable 2D laser scan"), std::string::npos) << done.errors;
}

TEST_F(PsmksBenchmarkLogs, TheFirstScansCanBeLeftOut)
{
  ASSERT_EQ(run(log("room") + " --matchers guess --skip-scans 2 --max-scans 3").exitCode, 0);
  EXPECT_EQ(rows()[0].at("scans"), 3);
  EXPECT_NEAR(rows()[0].at("path_m"), 0.21, 1e-6) << "the odometry before the first scan is none";
}

TEST_F(PsmksBenchmarkLogs, TheRelationsBesideTheLogAreFound)
{
  writeRelations({{0, 1}, {2, 3}});
  ASSERT_EQ(run(log("room") + " --matchers psmks,guess --references map").exitCode, 0);
  EXPECT_LT(rows()[0].at("relations_mean_m"), 0.002);
  EXPECT_LT(rows()[0].at("relations_mean_deg"), 0.1);
  // Each step of the odometry is 5 mm too long and turns 1 degree too little.
  EXPECT_NEAR(rows()[1].at("relations_mean_m"), 0.005, 1e-6);
  EXPECT_NEAR(rows()[1].at("relations_deviation_m"), 0, 1e-6);
  EXPECT_NEAR(rows()[1].at("relations_mean_deg"), 1, 1e-4);
  EXPECT_EQ(rows()[1].at("short_relations_mean_m"), rows()[1].at("relations_mean_m"));
}

TEST_F(PsmksBenchmarkLogs, RelationsOverLongTimesAreNotAmongTheShortOnes)
{
  writeRelations({{0, 1}});
  std::ofstream(path("room.relations"), std::ios::app)
      << std::fixed << log_.steps[0].stamp_s << ' ' << log_.steps[7].stamp_s + 60
      << " 0 0 0 0 0 0\n";
  ASSERT_EQ(run(log("room") + " --matchers guess").exitCode, 0);
  EXPECT_NEAR(rows()[0].at("short_relations_mean_m"), 0.005, 1e-6);
  EXPECT_NEAR(rows()[0].at("relations_mean_m"), 0.005, 1e-6) << "there is no scan at that time";
}

TEST_F(PsmksBenchmarkLogs, JumpsAreCountedWhereATruthIsKnown)
{
  const std::string flags = log("room") + " --matchers psmks,guess --references sequential";
  ASSERT_EQ(run(flags).exitCode, 0);
  EXPECT_TRUE(rows()[0].at("jumps").is_null());
  writeRelations({{0, 1}, {1, 2}});
  ASSERT_EQ(run(flags).exitCode, 0);
  for (const auto& row : rows()) EXPECT_EQ(row.at("jumps"), 0) << row;
  std::filesystem::remove(path("room.relations"));
  writeTruth("room.gt.tum");
  ASSERT_EQ(run(flags).exitCode, 0);
  for (const auto& row : rows()) EXPECT_EQ(row.at("jumps"), 0) << row;
}

TEST_F(PsmksBenchmarkLogs, ACarmenLogIsReadAsWell)
{
  std::ofstream(path("corner.log"))
      << "FLASER 5 2 2.8 2 2.8 2 0 0 0 0 0 0 10.0 host 10.0\n"
         "FLASER 5 1.9 2.7 1.9 2.7 1.9 0.1 0 0 0.1 0 0 11.0 host 11\n";
  ASSERT_EQ(run(path("corner.log") + " --matchers guess").exitCode, 0);
  EXPECT_EQ(table().at("table"), "corner");
  EXPECT_EQ(rows()[0].at("scans"), 2);
}

TEST_F(PsmksBenchmarkLogs, TheMotionsFurthestFromTheTruthAreDrawn)
{
  writeTruth("room.gt.tum", 0.4);
  const std::string flags =
      log("room") + " --references map --matchers psmks,guess --html " + path("l.html");
  ASSERT_EQ(run(flags + " --draw-worst 2").exitCode, 0);
  const std::string html = fileText(path("l.html"));
  EXPECT_EQ(firstFlaw(html), "");
  EXPECT_EQ(countOf("<figure>", html), 2 * 2);
  EXPECT_EQ(countOf("<summary>room, psmks, map</summary>", html), 1);
  EXPECT_LT(html.find("<figcaption>pair 7: 4"), html.find("<figcaption>pair ") + 1)
      << "the motion to the last scan is the worst, by 40 cm";
  std::filesystem::remove(path("room.gt.tum"));
  ASSERT_EQ(run(flags).exitCode, 0);
  EXPECT_EQ(countOf("<figure>", fileText(path("l.html"))), 0) << "nobody knows the truth";
}

TEST_F(PsmksBenchmarkLogs, WhatCannotBeAcceptedIsAUsageError)
{
  const std::string room = "logs " + log("room");
  expectUsageError(room + " --matchers nobody", "matcher 'nobody' is not known");
  expectUsageError(room + " --references moon", "moon");
  expectUsageError(room + " --set joint.nothing=1", "'nothing'");
  expectUsageError(room + " " + log("room") + " --ground-truth t.tum", "belongs to one LOG");
  expectUsageError(room + " " + log("room") + " --relations r", "belongs to one LOG");
}

TEST_F(PsmksBenchmarkLogs, AGroundTruthThatCannotBeReadIsAnInputError)
{
  const ProgramRun done = run(log("room") + " --matchers guess --ground-truth " + path("no.tum"));
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_TRUE(says(done.errors, {"ground truth", "no.tum"}));
}

TEST_F(PsmksBenchmarkLogs, RelationsThatCannotBeReadAreAnInputError)
{
  std::ofstream(path("broken.relations")) << "1 2 3\n";
  const ProgramRun done =
      run(log("room") + " --matchers guess --relations " + path("broken.relations"));
  EXPECT_EQ(done.exitCode, 2);
  EXPECT_TRUE(says(done.errors, {"relations", "broken.relations"}));
}
}  // namespace psmks
