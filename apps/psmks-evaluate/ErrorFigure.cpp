/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/ErrorFigure.h>
#include <psmks/eval/PathErrors.h>
#include <psmks/eval/Statistics.h>
#include <psmks/geometry/Angle.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace psmks
{
namespace
{
constexpr unsigned kTruthColour = 0x000000;
constexpr double kLeastShown_m = 1e-3, kLeastShown_deg = 1e-2;  // least values on logarithmic axes

Chart chartOf(const std::string& title, const std::string& xLabel, const std::string& yLabel)
{
  Chart chart;
  chart.title = title;
  chart.xLabel = xLabel;
  chart.yLabel = yLabel;
  return chart;
}

ChartSeries pathOf(const std::string& name, const Trajectory& trajectory,
                   const Pose2& T_shown_world)
{
  ChartSeries series{name, {}};
  for (const auto& [stamp_s, pose] : trajectory)
    series.points.push_back(T_shown_world * pose.translation());
  return series;
}

/** Turns a path to its first pose; where that has no heading, only moves it there. */
Pose2 T_start_world(const StampedPose& start)
{
  Pose2 pose = start.pose;
  if (!start.hasHeading()) pose.phi_rad = 0;
  return pose.inverse();
}

/** The paths, laid over the true path; without a ground truth with a common start. */
Chart pathsChart(const std::vector<Comparison>& comparisons, const std::optional<Trajectory>& truth)
{
  Chart chart = chartOf(truth ? "paths, aligned" : "paths", "x, m", "y, m");
  chart.equalAspect = true;
  for (const Comparison& c : comparisons)
    chart.series.push_back(
        pathOf(c.name, c.estimate, truth ? align(c.common) : T_start_world(c.estimate.front())));
  if (!truth) return chart;
  chart.series.push_back(pathOf("ground truth", *truth, {}));
  chart.series.back().style = ChartSeries::Style::DashedLine;
  chart.series.back().rgb = kTruthColour;
  return chart;
}

using ErrorValue = std::function<double(const PairError&)>;

double translation_m(const PairError& error) { return error.translation_m; }
double rotation_deg(const PairError& error) { return radToDeg(error.rotation_rad); }

double medianOf(const ChartSeries& series)
{
  std::vector<double> values;
  for (const Eigen::Vector2d& point : series.points) values.push_back(point.y());
  return median(values);
}

/** Makes the axis of the errors logarithmic where those of one curve are many times those of
 * another, which would lie on the axis else. */
void showSmallBesideLarge(Chart& chart, double leastShown)
{
  /** Medians that are farther apart are not seen together on a linear axis. Definition: a tenth of
   * the height. */
  constexpr double kFarApart = 10;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ChartSeries& series : chart.series)
  {
    least = std::min(least, medianOf(series));
    most = std::max(most, medianOf(series));
  }
  if (most <= kFarApart * least) return;
  chart.yRange.logarithmic = true;
  for (ChartSeries& series : chart.series)
    for (Eigen::Vector2d& point : series.points) point.y() = std::max(point.y(), leastShown);
}

Chart alongPathChart(const std::vector<Comparison>& comparisons, const std::string& quantity,
                     const std::string& unit, double leastShown, const ErrorValue& value)
{
  Chart chart = chartOf("error of " + quantity, "true path, m", "error, " + unit);
  for (const Comparison& c : comparisons)
  {
    ChartSeries series{c.name, {}};
    const auto lengths_m = truePathLengths_m(c.common);
    const auto errors = absoluteErrors(c.common, align(c.common));
    for (std::size_t i = 0; i < errors.size(); ++i)
      if (!std::isnan(value(errors[i]))) series.points.emplace_back(lengths_m[i], value(errors[i]));
    chart.series.push_back(series);
  }
  showSmallBesideLarge(chart, leastShown);
  return chart;
}

Chart relationsChart(const std::vector<Comparison>& comparisons, const std::string& quantity,
                     const std::string& unit, double leastShown, const ErrorValue& value)
{
  Chart chart = chartOf("relations: error of " + quantity, "time spanned, s", "error, " + unit);
  chart.xRange.logarithmic = chart.yRange.logarithmic = true;
  for (const Comparison& c : comparisons)
  {
    ChartSeries series{c.name, {}, ChartSeries::Style::Points};
    for (const auto& [span_s, error_m, error_rad] : c.relations)
      series.points.emplace_back(span_s, std::max(leastShown, value({error_m, error_rad})));
    chart.series.push_back(series);
  }
  return chart;
}
}  // namespace

Figure errorFigure(const std::vector<Comparison>& comparisons,
                   const std::optional<Trajectory>& truth)
{
  Figure figure;
  figure.columns = 3;
  figure.panels.push_back(pathsChart(comparisons, truth));
  if (truth)
  {
    figure.panels.push_back(
        alongPathChart(comparisons, "position", "m", kLeastShown_m, translation_m));
    figure.panels.push_back(
        alongPathChart(comparisons, "heading", "deg", kLeastShown_deg, rotation_deg));
  }
  if (!comparisons.front().relations.empty())
  {
    figure.panels.push_back(
        relationsChart(comparisons, "translation", "m", kLeastShown_m, translation_m));
    figure.panels.push_back(
        relationsChart(comparisons, "rotation", "deg", kLeastShown_deg, rotation_deg));
  }
  return figure;
}
}  // namespace psmks
