/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/growth/GrowthRun.h>
#include <apps/psmks-benchmark/pairs/PairsBenchmark.h>
#include <apps/psmks-benchmark/pairs/ScanPairs.h>
#include <psmks/eval/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kMillisecondsPerSecond = 1e3;
constexpr double kFieldOfView_rad = kPi;
constexpr const char* kFamily = "L180_medium";

/** The pairs with one number of rays, and the smallest time of each matcher on each pair. */
struct RayCountStep
{
  std::vector<ScanPair> pairs;
  std::vector<std::vector<double>> time_s;  //!< for each matcher a time for each pair
};

RayCountStep makeStep(int rays, const GrowthOptions& options)
{
  PairFamily family = pairFamily(kFamily);
  family.laser.grid = BeamGrid::centered(kFieldOfView_rad, rays);
  RayCountStep step;
  step.pairs = scanPairs(makePairSet(family, options.seed, options.pairs));
  const std::vector<double> untimed(step.pairs.size(), std::numeric_limits<double>::infinity());
  step.time_s.assign(options.matchers.size(), untimed);
  return step;
}

void measure(RayCountStep& step, const PairsBenchmarkOptions& options,
             const std::function<void(double)>& progress)
{
  const std::vector<PairsRun> runs =
      runPairs(step.pairs, {zeroGuesses(step.pairs)}, options, progress);
  for (std::size_t m = 0; m < runs.size(); ++m)
    for (std::size_t p = 0; p < step.pairs.size(); ++p)
      step.time_s[m][p] = std::min(step.time_s[m][p], runs[m].records[p].time_s);
}

PairsBenchmarkOptions onceEach(const GrowthOptions& options)
{
  PairsBenchmarkOptions once;
  once.matchers = options.matchers;
  once.matcherOptions = options.matcherOptions;
  return once;
}
}  // namespace

double GrowthRun::exponent() const
{
  if (rays.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const auto n = static_cast<Eigen::Index>(rays.size());
  const Eigen::ArrayXd x = Eigen::ArrayXi::Map(rays.data(), n).cast<double>().log();
  const Eigen::ArrayXd y = Eigen::ArrayXd::Map(median_s.data(), n).log();
  const Eigen::ArrayXd centred = x - x.mean();
  return (centred * y).sum() / centred.square().sum();
}

std::vector<GrowthRun> runGrowth(const GrowthOptions& options,
                                 const std::function<void(double)>& progress)
{
  std::vector<RayCountStep> steps;
  for (const int rays : options.rays) steps.push_back(makeStep(rays, options));

  const PairsBenchmarkOptions once = onceEach(options);
  const double total = static_cast<double>(steps.size()) * options.repeats;
  double done = 0;
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (auto& step : steps)
    {
      measure(step, once, [&](double share) { progress((done + share) / total); });
      ++done;
    }

  std::vector<GrowthRun> runs;
  for (std::size_t m = 0; m < options.matchers.size(); ++m)
  {
    runs.push_back({options.matchers[m], options.rays, {}});
    for (const auto& step : steps) runs.back().median_s.push_back(median(step.time_s[m]));
  }
  return runs;
}

Table growthTable(const std::vector<GrowthRun>& runs)
{
  Table table;
  table.title = "growth";
  table.columns = {{"matcher", "matcher"}, {"exponent", "exponent", 2}};
  for (const int rays : runs.front().rays)
  {
    const std::string number = std::to_string(rays);
    table.columns.push_back({number + " rays: ms", "median_ms_" + number + "_rays", 3});
  }
  for (const auto& run : runs)
  {
    std::vector<Table::Cell> row{run.matcher, run.exponent()};
    for (const double time_s : run.median_s) row.emplace_back(kMillisecondsPerSecond * time_s);
    table.rows.push_back(row);
  }
  return table;
}
}  // namespace psmks
