/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/Program.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
const std::string kGrowth = "'" PSMKS_PROGRAM "' growth --pairs 2 --repeats 1 ";

std::string temporary(const std::string& name)
{
  return testing::TempDir() + "psmks-benchmark-growth_" + name;
}
}  // namespace

TEST(PsmksBenchmarkGrowth, tellsTheTimeForEachNumberOfRaysAndHowItGrows)
{
  const std::string file = temporary("t.json");
  const ProgramRun run =
      runProgram(kGrowth + "--rays 181,361 --matchers psmks,icp-classic --json " + file);
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  const auto rows = nlohmann::json::parse(fileText(file)).at("tables").at(0).at("rows");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows)
  {
    const double few_ms = row.at("median_ms_181_rays"), many_ms = row.at("median_ms_361_rays");
    EXPECT_GT(few_ms, 0) << row;
    EXPECT_NEAR(row.at("exponent"), std::log(many_ms / few_ms) / std::log(361.0 / 181), 1e-6)
        << "through two points the line goes exactly: " << row;
  }
  std::filesystem::remove(file);
}

TEST(PsmksBenchmarkGrowth, oneNumberOfRaysHasNoExponent)
{
  const std::string file = temporary("one.json");
  ASSERT_EQ(runProgram(kGrowth + "--rays 91 --matchers guess --json " + file).exitCode, 0);
  const auto rows = nlohmann::json::parse(fileText(file)).at("tables").at(0).at("rows");
  EXPECT_TRUE(rows[0].at("exponent").is_null());
  std::filesystem::remove(file);
}

TEST(PsmksBenchmarkGrowth, drawsAChart)
{
  if (runProgram("gnuplot --version").exitCode != 0) GTEST_SKIP() << "gnuplot is not installed";
  const std::string file = temporary("chart.svg");
  ASSERT_EQ(runProgram(kGrowth + "--rays 91,181 --plot " + file).exitCode, 0);
  EXPECT_NE(fileText(file).find("Time of a match"), std::string::npos);
  std::filesystem::remove(file);
}

TEST(PsmksBenchmarkGrowth, whatCannotBeAcceptedIsAUsageError)
{
  const auto expectUsageError = [](const std::string& flags, const std::string& word)
  {
    const ProgramRun run = runProgram(kGrowth + flags);
    EXPECT_EQ(run.exitCode, 1) << flags;
    EXPECT_NE(run.errors.find(word), std::string::npos) << run.errors;
  };
  expectUsageError("--matchers nobody", "matcher 'nobody' is not known");
  expectUsageError("--rays 2", "--rays");
  expectUsageError("--rays 91 --plot /absent/chart.svg", "--plot");
}
}  // namespace psmks
