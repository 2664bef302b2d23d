/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/convergence/ConvergenceFigures.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
namespace
{
constexpr double kPercent = 100;

std::vector<double> inDegrees(const std::vector<double>& angles_rad)
{
  std::vector<double> angles_deg;
  for (const double angle_rad : angles_rad) angles_deg.push_back(radToDeg(angle_rad));
  return angles_deg;
}
}  // namespace

Table convergenceTable(const std::string& title, const ConvergenceGrid& grid,
                       const std::vector<ConvergenceMap>& maps)
{
  Table table;
  table.title = title;
  table.columns = {{"matcher", "matcher"}, {"turned by deg", "rotation_deg", 1}};
  for (const double distance_m : grid.distances_m)
    table.columns.push_back({"% at " + csvNumber(distance_m) + " m",
                             "success_at_" + csvNumber(distance_m) + "_m_percent", 1});
  for (const ConvergenceMap& map : maps)
    for (Eigen::Index r = 0; r < map.successShare.rows(); ++r)
    {
      const double rotation_rad = grid.rotations_rad[static_cast<std::size_t>(r)];
      std::vector<Table::Cell> row{map.matcher, radToDeg(rotation_rad)};
      for (const double share : map.successShare.row(r)) row.emplace_back(kPercent * share);
      table.rows.push_back(row);
    }
  return table;
}

HeatMap convergencePicture(const std::string& title, const ConvergenceGrid& grid,
                           const ConvergenceMap& map)
{
  const long mean_percent = std::lround(kPercent * map.successShare.mean());
  HeatMap picture;
  picture.title = title + ": " + std::to_string(mean_percent) + " % of all guesses";
  picture.xLabel = "distance of the guess from the truth, m";
  picture.yLabel = "rotation of the guess from the truth, deg";
  picture.valueLabel = "success (5 cm, 1 deg), %";
  picture.x = grid.distances_m;
  picture.y = inDegrees(grid.rotations_rad);
  picture.value = kPercent * map.successShare;
  picture.valueMax = kPercent;
  return picture;
}

std::vector<Panel> convergencePictures(const ConvergenceGrid& grid,
                                       const std::vector<ConvergenceMap>& maps)
{
  std::vector<Panel> pictures;
  for (const ConvergenceMap& map : maps)
    pictures.emplace_back(convergencePicture(map.matcher, grid, map));
  return pictures;
}
}  // namespace psmks
