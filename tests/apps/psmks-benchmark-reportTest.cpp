/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/ProgramTest.h>
#include <tests/support/Says.h>
#include <tests/unit/report/Markup.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using namespace test;
using nlohmann::json;

/** Tests of the pages and pictures of the benchmark on generated pairs. */
class PsmksBenchmarkReport : public test::ProgramTest
{
 protected:
  PsmksBenchmarkReport() : ProgramTest(PSMKS_PROGRAM) {}

  /** The table of convergence on a grid of 2 x 2 cells. */
  json convergence(const std::string& arguments) const
  {
    const ProgramRun done =
        run("convergence L180_medium --steps 2 --json " + path("t.json") + ' ' + arguments);
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return json::parse(fileText(path("t.json"))).at("tables").at(0);
  }
};

void expectSelfContained(const std::string& html)
{
  EXPECT_EQ(firstFlaw(html), "");
  for (const char* reference : {"src=", "<link", "<script", "url(", "href=\"http"})
    EXPECT_EQ(countOf(reference, html), 0) << reference;
}
}  // namespace

TEST_F(PsmksBenchmarkReport, ConvergenceHasACellForEveryDistanceAndRotation)
{
  //  20 deg |  guess: 0    0
  //   0 deg |       100    0
  //                 0 m  0.4 m
  const json table =
      convergence("--pairs 1 --max-distance_m 0.4 --max-rotation_deg 20 --matchers psmks,guess");
  EXPECT_EQ(table.at("table"), "L180_medium");
  const json& rows = table.at("rows");
  ASSERT_EQ(rows.size(), 4U);
  const auto expectRow = [&rows](std::size_t row, const char* matcher, double rotation_deg,
                                 double atTruth_percent, double away_percent)
  {
    EXPECT_EQ(rows[row].at("matcher"), matcher);
    EXPECT_NEAR(rows[row].at("rotation_deg"), rotation_deg, 1e-9);
    EXPECT_EQ(rows[row].at("success_at_0_m_percent"), atTruth_percent) << rows[row];
    EXPECT_EQ(rows[row].at("success_at_0.4_m_percent"), away_percent) << rows[row];
  };
  expectRow(0, "psmks", 0, 100, 100);
  expectRow(1, "psmks", 20, 100, 100);
  expectRow(2, "guess", 0, 100, 0);
  expectRow(3, "guess", 20, 0, 0);
}

TEST_F(PsmksBenchmarkReport, ConvergenceIsTheSameForTheSameSeed)
{
  const std::string hard = "--pairs 3 --max-rotation_deg 45 --matchers icp-classic --seed ";
  const json first = convergence(hard + "3");
  EXPECT_EQ(convergence(hard + "3"), first);
  bool differs = false;
  for (const char* seed : {"4", "5", "6"}) differs = differs || convergence(hard + seed) != first;
  EXPECT_TRUE(differs);
}

TEST_F(PsmksBenchmarkReport, ConvergenceOfAMatcherEndsWhereItsSearchDoes)
{
  const auto farOff_percent = [this](const std::string& radius_m)
  {
    const json table =
        convergence("--pairs 3 --max-distance_m 2 --max-rotation_deg 5 --matchers " +
                    ("psmks --set joint.wide_radius_m=0 --set joint.search_radius_m=" + radius_m));
    return table.at("rows").at(0).at("success_at_2_m_percent").get<double>();
  };
  EXPECT_EQ(farOff_percent("0.5"), 0);
  EXPECT_GT(farOff_percent("3"), 50);
}

TEST_F(PsmksBenchmarkReport, ConvergenceDrawsAPictureForEachMatcher)
{
  convergence("--pairs 1 --matchers psmks,guess --output " + path("pictures") + " --html " +
              path("c.html"));
  const std::string html = fileText(path("c.html"));
  expectSelfContained(html);
  EXPECT_TRUE(
      says(html, {"<h1>Areas of convergence</h1>", "psmks-benchmark convergence L180_medium",
                  "<caption>L180_medium</caption>"}));
  const bool drawn = hasGnuplot();
  EXPECT_EQ(countOf("<svg", html), drawn ? 2 : 0);
  for (const char* matcher : {"psmks", "guess"})
    EXPECT_EQ(
        std::filesystem::exists(path("pictures/convergence-" + std::string(matcher) + ".png")),
        drawn)
        << matcher;
}

TEST_F(PsmksBenchmarkReport, ConvergenceOfWhatCannotBeAcceptedSaysWhy)
{
  const auto expectError =
      [this](const std::string& arguments, int exitCode, const std::string& word)
  {
    const ProgramRun done = run("convergence " + arguments);
    EXPECT_EQ(done.exitCode, exitCode) << arguments;
    EXPECT_TRUE(says(done.errors, {word}));
  };
  expectError("moon", 1, "'moon'");
  expectError("L180_medium --matchers nobody", 1, "'nobody'");
  expectError("L180_medium --set joint.nothing=1", 1, "'nothing'");
  expectError("L180_medium --steps 1", 1, "--steps");
  expectError("L180_medium --html /absent/c.html", 1, "'/absent/c.html' cannot be created");
  expectError("absent.pairs", 2, "absent.pairs");
}

TEST_F(PsmksBenchmarkReport, PairsBecomeOnePage)
{
  const ProgramRun done =
      run("pairs L180_small people --pairs 3 --matchers psmks,guess --html " + path("p.html"));
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const std::string html = fileText(path("p.html"));
  expectSelfContained(html);
  EXPECT_TRUE(says(
      html, {"psmks-benchmark pairs L180_small people --pairs 3", "<caption>L180_small</caption>",
             "<caption>people</caption>", "<h2>people, guess: odometry</h2>"}));
  EXPECT_EQ(countOf("<table>", html), 2);
  EXPECT_EQ(countOf("<details>", html), 2 * 2 * 2);  // sets, matchers, guesses
  EXPECT_EQ(countOf("<figure>", html), 2 * 2 * 2 * 3);
  EXPECT_EQ(countOf("<title>Errors of position</title>", html), hasGnuplot() ? 2 * 2 : 0);
}

TEST_F(PsmksBenchmarkReport, WithoutGnuplotThePageSaysSo)
{
  const ProgramRun done =
      run("pairs L180_small --pairs 1 --matchers guess --html p.html", "PATH=/nonexistent");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const std::string html = fileText(path("p.html"));
  expectSelfContained(html);
  EXPECT_EQ(countOf("There are no charts: gnuplot cannot be run", html), 1);
  EXPECT_EQ(countOf("<figure>", html), 2);
}
}  // namespace psmks
