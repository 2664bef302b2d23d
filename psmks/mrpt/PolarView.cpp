/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CPointsMap.h>
#include <psmks/mrpt/Compat.h>
#include <psmks/mrpt/PolarView.h>
#include <psmks/mrpt/SurfaceView.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace psmks
{
using mrpt::maps::CMetricMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CPointsMap;

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

Scan viewOfPoints(const CPointsMap& map, const Pose2& T_map_sensor, const BeamGrid& grid,
                  double maxGap_m)
{
  SurfaceView view(grid, maxGap_m);
  const Pose2 T_sensor_map = T_map_sensor.inverse();
  const auto& x = map.getPointsBufferRef_x();
  const auto& y = map.getPointsBufferRef_y();
  for (std::size_t i = 0; i < x.size(); ++i)
    view.addPoint(T_sensor_map * Eigen::Vector2d(x[i], y[i]));

  Scan scan = emptyScan(grid);
  view.draw(scan);
  return scan;
}

double diagonal_m(const COccupancyGridMap2D& map)
{
  return std::hypot(map.getXMax() - map.getXMin(), map.getYMax() - map.getYMin());
}

bool contains(const COccupancyGridMap2D& map, const Eigen::Vector2d& p)
{
  return p.x() > map.getXMin() && p.x() < map.getXMax() && p.y() > map.getYMin() &&
         p.y() < map.getYMax();
}

/** Standard deviation of a cast range. The caster stops anywhere within its last step, and the
 *  surface lies anywhere within its cell: two uniform distributions, whose standard deviations are
 *  their widths over the root of 12. */
double castSigma_m(const COccupancyGridMap2D& map, double step_cells)
{
  const double uniform = 1 / std::sqrt(12.0);
  return map.getResolution() * uniform * std::hypot(1.0, step_cells);
}

Scan viewOfGrid(const COccupancyGridMap2D& map, const Pose2& T_map_sensor, const BeamGrid& grid)
{
  constexpr float kFreeAbove = 0.4f;  // a cell that is free with a lower probability stops a ray
  const double step_cells = compat::raytraceStep_cells(map);
  // The caster compares the number of its steps with the limit in cells, so that steps shorter
  // than a cell shorten the range that it reaches.
  const double limit_m = diagonal_m(map) / step_cells;

  Scan scan = emptyScan(grid);
  scan.rangeSigma_m = castSigma_m(map, step_cells);
  if (!contains(map, T_map_sensor.translation())) return scan;
  for (int ray = 0; ray < grid.count(); ++ray)
  {
    const double direction_rad = T_map_sensor.phi_rad + grid.bearing_rad(ray);
    float range_m = 0;
    bool hit = false;
    map.simulateScanRay(T_map_sensor.x_m, T_map_sensor.y_m, direction_rad, range_m, hit, limit_m,
                        kFreeAbove);
    scan.range_m[static_cast<std::size_t>(ray)] = range_m;
    scan.valid[static_cast<std::size_t>(ray)] = hit;
  }
  return scan;
}

/** The part of a multi-metric map that is turned into a scan: the first point map that is not
 *  empty, because points are finer than cells, else a grid, else an empty point map. Null where
 *  there is none of these. */
const CMetricMap* viewablePart(const CMultiMetricMap& map)
{
  const CMetricMap* viewable = nullptr;
  for (const auto& part : map.maps)
  {
    const bool isPoints = dynamic_cast<const CPointsMap*>(part.get()) != nullptr;
    if (isPoints && !part->isEmpty()) return part.get();
    if (isPoints || dynamic_cast<const COccupancyGridMap2D*>(part.get()))
      viewable = isPoints && viewable ? viewable : part.get();
  }
  return viewable;
}

[[noreturn]] void refuse(const CMetricMap& map)
{
  throw std::invalid_argument(
      std::string("psmks::ScanMatcher: a map of class ") + map.GetRuntimeClass()->className +
      " cannot be matched, allowed: point maps, COccupancyGridMap2D, and CMultiMetricMap with one "
      "of these");
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

Scan polarView(const CMetricMap& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m)
{
  const auto* multi = dynamic_cast<const CMultiMetricMap*>(&map);
  const CMetricMap* viewable = multi ? viewablePart(*multi) : &map;
  const auto* points = dynamic_cast<const CPointsMap*>(viewable);
  const auto* cells = dynamic_cast<const COccupancyGridMap2D*>(viewable);
  if (!points && !cells) refuse(map);

  if (!T_map_sensor.isFinite()) return emptyScan(grid);
  return points ? viewOfPoints(*points, T_map_sensor, grid, maxGap_m)
                : viewOfGrid(*cells, T_map_sensor, grid);
}
}  // namespace psmks
