/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace psmks
{
/** One curve or cloud of points. */
struct ChartSeries
{
  enum class Style
  {
    Line,
    ThinLine,
    DashedLine,
    Points
  };

  std::string name;                     //!< in the legend; empty = not there
  std::vector<Eigen::Vector2d> points;  //!< one that is not finite breaks the line
  Style style = Style::Line;
  std::optional<unsigned> rgb = std::nullopt;  //!< 0xrrggbb; default: the next of a palette
};

/** What a chart shows of an axis; NaN = as far as the data reach. */
struct ChartRange
{
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  bool logarithmic = false;  //!< what is not positive is not shown
};

/** Series over one pair of axes, as data. Texts are shown as they are: no markup. */
struct Chart
{
  std::string title;
  std::string xLabel, yLabel;  //!< with units
  std::vector<ChartSeries> series;
  ChartRange xRange, yRange;
  bool equalAspect = false;  //!< a metre is as long upwards as sideways: maps and paths
};

/** A picture of one chart, 1000 x 700 pixels; see save() in Figure.h. */
bool save(const Chart& chart, const std::string& path, std::string* reason = nullptr);

/** A line for each wall, map segment, ...: the ends of each, with breaks in between. */
ChartSeries lineSegments(const std::string& name,
                         const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& ends);
}  // namespace psmks
