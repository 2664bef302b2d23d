/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/growth/GrowthCommand.h>
#include <apps/support/Progress.h>
#include <psmks/eval/Chart.h>

#include <limits>

namespace psmks
{
namespace
{
constexpr double kMillisecondsPerSecond = 1e3;
constexpr int kLeastRays = 19;  // over 180 degrees; fewer rays do not show a room

Chart growthChart(const std::vector<GrowthRun>& runs)
{
  Chart chart;
  chart.title = "Time of a match";
  chart.xLabel = "rays";
  chart.yLabel = "median time, ms";
  chart.xRange.logarithmic = chart.yRange.logarithmic = true;
  for (const auto& run : runs)
  {
    ChartSeries series;
    series.name = run.matcher;
    for (std::size_t r = 0; r < run.rays.size(); ++r)
      series.points.emplace_back(run.rays[r], kMillisecondsPerSecond * run.median_s[r]);
    chart.series.push_back(series);
  }
  return chart;
}
}  // namespace

GrowthCommand::GrowthCommand(CLI::App& app)
{
  addMatchersFlag(app, options_.matchers);
  app.add_option("--rays", options_.rays, "of a scan, over 180 degrees")
      ->delimiter(',')
      ->check(CLI::Range(kLeastRays, std::numeric_limits<int>::max()))
      ->capture_default_str();
  app.add_option("--pairs", options_.pairs, "of each number of rays, at the same places")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addRepeatsFlag(app, options_.repeats);
  app.add_option("--seed", options_.seed, "of the worlds, the places and the noise")
      ->capture_default_str();
  app.add_option("--plot", plotPath_, "draw a chart, PNG or SVG")->type_name("FILE");
  output_.addFlags(app);
}

ExitCode GrowthCommand::run()
{
  checkMatchers(options_.matchers, options_.matcherOptions);
  output_.check();
  std::vector<GrowthRun> runs;
  {
    Progress progress("growth");
    runs = runGrowth(options_, [&](double share) { progress.show(share); });
  }
  output_.write({growthTable(runs)});

  std::string reason;
  if (!plotPath_.empty() && !save(growthChart(runs), plotPath_, &reason))
    throw ProgramError(kUsage, "--plot: " + reason);
  return kOk;
}
}  // namespace psmks
