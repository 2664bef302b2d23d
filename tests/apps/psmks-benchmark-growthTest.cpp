/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/ProgramTest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
const std::string kGrowth = "growth --pairs 2 --repeats 1 ";

class PsmksBenchmarkGrowth : public test::ProgramTest
{
 protected:
  PsmksBenchmarkGrowth() : ProgramTest(PSMKS_PROGRAM) {}
};
}  // namespace

TEST_F(PsmksBenchmarkGrowth, TellsTheTimeForEachNumberOfRaysAndHowItGrows)
{
  const ProgramRun done =
      run(kGrowth + "--rays 181,361 --matchers psmks,icp-classic --json t.json");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  const auto rows = nlohmann::json::parse(fileText(path("t.json"))).at("tables").at(0).at("rows");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows)
  {
    const double few_ms = row.at("median_ms_181_rays"), many_ms = row.at("median_ms_361_rays");
    EXPECT_GT(few_ms, 0) << row;
    EXPECT_NEAR(row.at("exponent"), std::log(many_ms / few_ms) / std::log(361.0 / 181), 1e-6)
        << "through two points the line goes exactly: " << row;
  }
}

TEST_F(PsmksBenchmarkGrowth, OneNumberOfRaysHasNoExponent)
{
  ASSERT_EQ(run(kGrowth + "--rays 91 --matchers guess --json one.json").exitCode, 0);
  const auto rows = nlohmann::json::parse(fileText(path("one.json"))).at("tables").at(0).at("rows");
  EXPECT_TRUE(rows[0].at("exponent").is_null());
}

TEST_F(PsmksBenchmarkGrowth, DrawsAChart)
{
  if (!hasGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  ASSERT_EQ(run(kGrowth + "--rays 91,181 --plot chart.svg").exitCode, 0);
  EXPECT_NE(fileText(path("chart.svg")).find("Time of a match"), std::string::npos);
}

TEST_F(PsmksBenchmarkGrowth, WhatCannotBeAcceptedIsAUsageError)
{
  const auto expectUsageError = [this](const std::string& flags, const std::string& word)
  {
    const ProgramRun done = run(kGrowth + flags);
    EXPECT_EQ(done.exitCode, 1) << flags;
    EXPECT_NE(done.errors.find(word), std::string::npos) << done.errors;
  };
  expectUsageError("--matchers nobody", "matcher 'nobody' is not known");
  expectUsageError("--rays 2", "--rays");
  expectUsageError("--rays 91 --plot /absent/chart.svg", "--plot");
}
}  // namespace psmks
