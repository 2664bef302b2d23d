/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapFrame.h>
#include <psmks/eval/RoundNumber.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace psmks
{
namespace
{
constexpr double kMargin_m = 1.0;
/** Share of the points that may lie outside the frame on each side. */
constexpr double kOutlierShare = 0.002;

/** The range of values without the share kOutlierShare at either end. */
std::pair<double, double> bulkOf(std::vector<double> values)
{
  const auto skipped =
      static_cast<std::ptrdiff_t>(kOutlierShare * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + skipped, values.end());
  const double low = values[static_cast<std::size_t>(skipped)];
  std::nth_element(values.begin(), values.end() - 1 - skipped, values.end());
  return {low, *(values.end() - 1 - skipped)};
}
}  // namespace

double MapFrame::gridSpacing_m() const
{
  /** Least number of spacings along the longer side. Definition: few enough for their numbers. */
  constexpr double kLeast = 4;
  return roundNumber(size_m().maxCoeff() / kLeast);
}

std::vector<double> MapFrame::gridCoordinates_m(int axis) const
{
  const double spacing_m = gridSpacing_m();
  std::vector<double> coordinates_m;
  for (double n = std::ceil(min_m[axis] / spacing_m); n * spacing_m <= max_m[axis]; ++n)
    coordinates_m.push_back(n * spacing_m);
  return coordinates_m;
}

MapFrame frameOf(const ScanMap& map)
{
  std::vector<double> xs, ys;
  for (const auto& p : map.points_m)
  {
    xs.push_back(p.x());
    ys.push_back(p.y());
  }
  const auto [xMin, xMax] = bulkOf(std::move(xs));
  const auto [yMin, yMax] = bulkOf(std::move(ys));
  MapFrame frame{{xMin, yMin}, {xMax, yMax}};
  for (const auto& pose : map.path)
  {
    frame.min_m = frame.min_m.cwiseMin(pose.translation());
    frame.max_m = frame.max_m.cwiseMax(pose.translation());
  }
  frame.min_m.array() -= kMargin_m;
  frame.max_m.array() += kMargin_m;
  return frame;
}

std::string lengthText(double x_m)
{
  std::ostringstream text;
  text << x_m;
  return text.str();
}
}  // namespace psmks
