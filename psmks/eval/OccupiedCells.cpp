/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/OccupiedCells.h>
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
int cellOf(double coordinate_m)
{
  constexpr double kFarthest = 1e9;  // an int holds it
  return static_cast<int>(
      std::clamp(std::floor(coordinate_m / OccupiedCells::kCell_m), -kFarthest, kFarthest));
}
}  // namespace

void OccupiedCells::add(const Scan& scan, const Pose2& T_map_sensor)
{
  cleanScan(scan, PreprocessingOptions(), cleaned_);
  for (int ray = 0; ray < cleaned_.rays(); ++ray)
  {
    const double range_m = cleaned_.range_m[static_cast<std::size_t>(ray)];
    if (!cleaned_.isValid(ray) || range_m < kMinRange_m || range_m > kMaxRange_m) continue;
    const Eigen::Vector2d p = T_map_sensor * cleaned_.point_m(ray);
    cells_.emplace(cellOf(p.x()), cellOf(p.y()));
  }
}
}  // namespace psmks
