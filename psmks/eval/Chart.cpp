/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Chart.h>

namespace psmks
{
ChartSeries lineSegments(const std::string& name,
                         const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& ends)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  ChartSeries series;
  series.name = name;
  series.style = ChartSeries::Style::ThinLine;
  for (const auto& [from, to] : ends)
  {
    series.points.push_back(from);
    series.points.push_back(to);
    series.points.emplace_back(kNaN, kNaN);
  }
  return series;
}
}  // namespace psmks
