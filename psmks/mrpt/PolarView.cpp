/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/PolarView.h>
#include <psmks/mrpt/SurfaceView.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
using mrpt::maps::CMetricMap;

namespace
{
/** A scan without a valid ray. */
Scan emptyScan(const BeamGrid& grid)
{
  Scan scan;
  scan.grid = grid;
  scan.range_m.assign(static_cast<std::size_t>(grid.count()), 0.0);
  scan.valid.assign(static_cast<std::size_t>(grid.count()), 0);
  return scan;
}

}  // namespace

void listFields(OptionTable& table, ViewOptions& o)
{
  table.beginSection("view", "Polar view of a map, where maps are matched instead of scans.");
  table.add("rays", o.rays, 2, 100000, "rays of the view");
  table.add("field_of_view_deg", o.fieldOfView_rad, Unit::Degree, degToRad(1), 2 * kPi,
            "angle from the first to the last ray; 360: all round");
  table.add("max_gap_m", o.maxGap_m, Unit::Metre, 0, 10,
            "points of a map closer together than this are one surface");
  table.add("sensor_x_m", o.T_map_sensor.x_m, Unit::Metre, -100, 100,
            "position of the scanner in the current map, from where the map is looked at");
  table.add("sensor_y_m", o.T_map_sensor.y_m, Unit::Metre, -100, 100, "see sensor_x_m");
  table.add("sensor_phi_deg", o.T_map_sensor.phi_rad, Unit::Degree, -kPi, kPi,
            "direction of the scanner in the current map: the middle of field_of_view_deg");
}

Scan polarView(const MapPoints& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m)
{
  Scan scan = emptyScan(grid);
  scan.rangeSigma_m = map.cellSigma_m();
  if (!T_map_sensor.isFinite()) return scan;
  SurfaceView view(grid, std::max(maxGap_m, std::sqrt(2.0) * map.cell_m));
  const Pose2 T_sensor_map = T_map_sensor.inverse();
  const Eigen::Matrix2d rotation = T_sensor_map.rotation();
  for (const Eigen::Vector2d& point_m : map.points_m)
    view.addPoint(rotation * point_m + T_sensor_map.translation());
  view.draw(scan);
  return scan;
}

Scan polarView(const CMetricMap& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m)
{
  return polarView(pointsOf(map), T_map_sensor, grid, maxGap_m);
}
}  // namespace psmks
