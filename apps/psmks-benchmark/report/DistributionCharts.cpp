/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/DistributionCharts.h>
#include <psmks/eval/Statistics.h>

#include <cmath>

namespace psmks
{
namespace
{
constexpr int kPercent = 100;
constexpr double kMillimetresPerMetre = 1e3;
constexpr double kMillisecondsPerSecond = 1e3;
constexpr double kShortestTime_ms = 1e-3;  // least time shown; no match is faster
constexpr unsigned kBoundColour = 0x808080;
constexpr std::size_t kSolidLines = 7;  // number of colours of a chart; further lines are dashed

/** The distribution of values: the limit below which each percent of them lies. */
ChartSeries distribution(const std::string& name, const std::vector<double>& values)
{
  ChartSeries series;
  series.name = name;
  for (int percent = 1; percent <= kPercent; ++percent)
    series.points.emplace_back(quantile(values, static_cast<double>(percent) / kPercent), percent);
  return series;
}

Chart shareChart(const std::string& title, const std::string& limit)
{
  Chart chart;
  chart.title = title;
  chart.xLabel = limit;
  chart.yLabel = "matches within, %";
  chart.xRange.logarithmic = true;
  chart.yRange = {0, kPercent};
  return chart;
}

template <class Value>
void addRuns(Chart& chart, const PairsSetResult& set, const std::string& guess, Value value)
{
  for (const PairsRun& run : set.runs)
  {
    if (run.guess != guess) continue;
    std::vector<double> values;
    for (const PairRecord& record : run.records) values.push_back(value(record));
    ChartSeries series = distribution(run.matcher, values);
    if (chart.series.size() >= kSolidLines) series.style = ChartSeries::Style::DashedLine;
    chart.series.push_back(series);
  }
}

template <class Value>
void addBound(Chart& chart, const std::vector<PairError>& errors, Value value)
{
  if (errors.empty()) return;
  std::vector<double> values;
  for (const PairError& error : errors) values.push_back(value(error));
  ChartSeries series = distribution("bound", values);
  series.style = ChartSeries::Style::DashedLine;
  series.rgb = kBoundColour;
  chart.series.push_back(series);
}
}  // namespace

std::vector<Chart> distributionCharts(const PairsSetResult& set, const std::string& guess)
{
  const auto translation_mm = [](const PairError& error)
  { return kMillimetresPerMetre * error.translation_m; };
  const auto rotation_deg = [](const PairError& error) { return radToDeg(error.rotation_rad); };
  const std::vector<PairError> boundErrors = drawnErrors(set.bounds);

  Chart position = shareChart("Errors of position", "error, mm");
  addRuns(position, set, guess, [&](const PairRecord& r) { return translation_mm(r.error()); });
  addBound(position, boundErrors, translation_mm);

  Chart heading = shareChart("Errors of heading", "error, deg");
  addRuns(heading, set, guess, [&](const PairRecord& r) { return rotation_deg(r.error()); });
  addBound(heading, boundErrors, rotation_deg);

  Chart time = shareChart("Times", "time of a match, ms");
  time.xRange.min = kShortestTime_ms;
  addRuns(time, set, guess, [](const PairRecord& r) { return kMillisecondsPerSecond * r.time_s; });
  return {position, heading, time};
}
}  // namespace psmks
