/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/apps/BenchmarkOnLogs.h>
#include <tests/support/Says.h>

namespace psmks
{
namespace
{
using namespace test;

class PsmksBenchmarkClosure : public BenchmarkOnLogs
{
};
}  // namespace

TEST_F(PsmksBenchmarkClosure, MatchesAroundATriangleMissByNoMoreThanTheNoise)
{
  const ProgramRun done = run("closure " + log("room") + " --apart 1,2");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  EXPECT_EQ(table().at("table"), "room");
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_EQ(rows()[0].at("scans_apart"), 1);
  EXPECT_EQ(rows()[1].at("scans_apart"), 2);
  for (const auto& row : rows())
  {
    EXPECT_GT(row.at("triangles"), 0);
    EXPECT_EQ(row.at("left_out"), 0);
    EXPECT_LT(row.at("translation_median_mm"), 5);
    EXPECT_LT(row.at("nees"), 12) << "99.9 % of the means of two are below 9";
  }
}

TEST_F(PsmksBenchmarkClosure, TheSameSeedGivesTheSameFigures)
{
  const auto nees = [this](const std::string& seed)
  {
    run("closure " + log("room") + " --seed " + seed);
    return rows().at(0).at("nees");
  };
  EXPECT_EQ(nees("3"), nees("3"));
  EXPECT_NE(nees("3"), nees("4"));
}

TEST_F(PsmksBenchmarkClosure, ALogOfTwoScansHasNoTriangle)
{
  ASSERT_EQ(run("closure " + log("room") + " --max-scans 2").exitCode, 0);
  EXPECT_EQ(rows().at(0).at("triangles"), 0);
}

TEST_F(PsmksBenchmarkClosure, WhatCannotBeAcceptedSaysWhy)
{
  const std::string room = "closure " + log("room");
  expectUsageError(room + " --draws 9", "--draws");
  expectUsageError(room + " --apart 0", "--apart");
  EXPECT_EQ(run("closure " + log("absent")).exitCode, 2);
}
}  // namespace psmks
