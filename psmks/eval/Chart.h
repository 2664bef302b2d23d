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
/** A curve or a set of points. */
struct ChartSeries
{
  enum class Style
  {
    Line,
    ThinLine,
    DashedLine,
    Points
  };

  std::string name;                     //!< text in the legend; empty = no entry
  std::vector<Eigen::Vector2d> points;  //!< a point that is not finite interrupts the curve
  Style style = Style::Line;
  std::optional<unsigned> rgb = std::nullopt;  //!< 0xrrggbb; default: the next colour of a palette
};

/** The part of an axis that a chart shows. A NaN stands for the limit of the data. */
struct ChartRange
{
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  bool logarithmic = false;  //!< values that are not positive are not shown
};

/** Series over one pair of axes. Texts are shown as they are, without markup. */
struct Chart
{
  std::string title;
  std::string xLabel, yLabel;  //!< with units
  std::vector<ChartSeries> series;
  ChartRange xRange, yRange;
  bool equalAspect = false;  //!< a unit has the same length on both axes, as in maps
};

/** Draws a picture of one chart with 1000 x 700 pixels; see save() in Figure.h. */
bool save(const Chart& chart, const std::string& path, std::string* reason = nullptr);

/** A series of separate straight lines, such as walls, from the two ends of each. */
ChartSeries lineSegments(const std::string& name,
                         const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& ends);
}  // namespace psmks
