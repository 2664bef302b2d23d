/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/CMetricMap.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace psmks
{
/** Points on the surfaces that a map shows, in the frame of the map. */
struct MapPoints
{
  std::vector<Eigen::Vector2d> points_m;

  /** Side of the cells of which the points are the middles; 0 where the map holds points. */
  double cell_m = 0;

  /** Standard deviation of a surface that lies anywhere within its cell: the width of a uniform
   *  distribution over the root of 12. 0 where the map holds points. */
  double cellSigma_m() const;
};

/** A part of the plane: what is closer to `middle_m` than `reach_m` in x and in y. */
struct MapRegion
{
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  double reach_m = std::numeric_limits<double>::infinity();
};

/** The points of the part of a map that lies in a region.
 *
 *  - Of a point map, its finite points.
 *  - Of an occupancy grid, the middles of the cells that are more likely occupied than free,
 *    however little more: one hit by the stock ini files of MRPT leaves a cell free with 46 %.
 *  - Of a multi-metric map, those of the first point map that is not empty, because points are
 *    finer than cells, else those of a grid.
 *
 *  A region that is not finite in its middle holds no points.
 *  @throws std::invalid_argument naming the class of a map that is none of these */
MapPoints pointsOf(const mrpt::maps::CMetricMap& map, const MapRegion& region = {});
}  // namespace psmks
