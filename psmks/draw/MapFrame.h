/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace psmks
{
/** The rectangle of the world that a picture shows. */
struct MapFrame
{
  Eigen::Vector2d min_m, max_m;

  Eigen::Vector2d size_m() const { return max_m - min_m; }

  /** Distance of the lines of a grid: a round length, so that four to ten fit along the longer
   * side. */
  double gridSpacing_m() const;

  /** The multiples of gridSpacing_m() within the frame.
   *  @param axis 0 for x, 1 for y */
  std::vector<double> gridCoordinates_m(int axis) const;
};

/** The frame of a map: its path and its points but for the few farthest, with a margin of 1 m.
 *  @param map with points and a path */
MapFrame frameOf(const ScanMap& map);

/** A round length or coordinate as text, without zeros at its end: "0.5", "20". */
std::string lengthText(double x_m);
}  // namespace psmks
