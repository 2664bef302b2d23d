/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/CMetricMap.h>
#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/mrpt/MapPoints.h>

namespace psmks
{
/** The scanner by which a map is turned into a scan. */
struct ViewOptions
{
  int rays = 720;
  double fieldOfView_rad = 2 * kPi;
  double maxGap_m = 0.10;   //!< points closer together are one surface, see SurfaceView
  Pose2 T_map_sensor = {};  //!< where the scanner stands in a map that was made of its scan
};

/** The section [view]. */
void listFields(OptionTable& table, ViewOptions& options);

/** The scan that a scanner would take of a map.
 *
 *  - Of a point map, the nearest points of each bearing are joined where they lie close together. A
 *    ray is valid where it meets such a join. Surfaces behind nearer ones are hidden, and single
 *    points are left out. Rays between two points share the noise of these points. The standard
 *    deviations of a match on a map with fewer points than rays are therefore too small, by about
 *    the root of the number of rays for each point.
 *  - Of an occupancy grid, the middles of the occupied cells are such points, see pointsOf(), so
 *    that a range ends within a cell and not at its face. The standard deviation of a range stands
 *    for the width of a cell.
 *  - Of a multi-metric map, the first point map that is not empty is taken, else a grid.
 *
 *  An empty map, or a pose that is not finite, gives a scan without a valid ray.
 *  @param T_map_sensor where the scanner stands in the map
 *  @param grid bearings of the scanner's rays
 *  @param maxGap_m see ViewOptions; the diagonal of a cell where that is wider
 *  @throws std::invalid_argument naming the class of a map that is none of these */
Scan polarView(const mrpt::maps::CMetricMap& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m);

/** The same of the points of a map. */
Scan polarView(const MapPoints& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m);
}  // namespace psmks
