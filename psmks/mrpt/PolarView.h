/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/CMetricMap.h>
#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

namespace psmks
{
/** The scanner that a map is looked at with. */
struct ViewOptions
{
  int rays = 720;
  double fieldOfView_rad = 2 * kPi;
  double maxGap_m = 0.10;   //!< between points of one surface, beside the spacing of the rays
  Pose2 T_map_sensor = {};  //!< where the scanner stands in a map made of its scan
};

void listFields(OptionTable& table, ViewOptions& options);

/** The scan that a scanner standing at `T_map_sensor` would take of a map.
 *
 *  - Point maps: the nearest points of each bearing, joined where they lie close together; a ray is
 *    valid where it meets such a join. Surfaces behind nearer ones are hidden, single points are
 *    left out. Rays between points repeat their noise, so that a covariance that rests on a map
 *    sparser than the rays is too small by about the root of the surplus.
 *  - Occupancy grids: MRPT's ray caster up to the map's diagonal; the range sigma states its step
 *    and the width of a cell.
 *  - Multi-metric maps: their first point map that is not empty, else a grid.
 *
 *  An empty map, or a pose that is not finite, gives a scan without a valid ray.
 *  @throws std::invalid_argument naming the class of a map that is none of these */
Scan polarView(const mrpt::maps::CMetricMap& map, const Pose2& T_map_sensor, const BeamGrid& grid,
               double maxGap_m);
}  // namespace psmks
