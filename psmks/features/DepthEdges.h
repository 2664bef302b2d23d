/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Where the surface of an object ends and the scanner sees past it, to something farther away or
 * to nothing. The end of the surface lies between two rays, so that its bearing is measured, about
 * as well as the rays are dense:
 *
 *        -----------   wall
 *         x       x
 *      .  o---o---o  .       o  object, x  edges, at the bearings between the outermost rays on the
 *       \ |   |   | /           object and the rays that pass it
 *          scanner
 *
 * A wall has no edge where it leaves the range of the scanner, nor where an object hides it, for
 * both places change with that of the scanner. */
struct DepthEdge
{
  Eigen::Vector2d point_m;   //!< the end of the object, sensor frame
  Eigen::Vector2d sight;     //!< unit vector from the scanner to it
  double acrossVariance_m2;  //!< of the point, across the line of sight
  double alongVariance_m2;   //!< of the point, along the line of sight
  int step;                  //!< the side on which the object ends: +1 towards the next ray, or -1
};

/** Finds the depth edges of a scan.
 *
 * A run of rays without a return past the object counts as nothing there only if it is longer than
 * the holes that faults tear into surfaces: the share p of such rays is counted inside of surfaces.
 * The outermost rays on the object may be lost themselves, which adds the variance p / (1 - p)^2 of
 * a geometric distribution to that of a uniform one, 1/12, in squares of the distance between rays.
 *
 * Differs from the paper: it matches no ends of objects.
 *
 *  @param[out] edges what it held is replaced */
void findDepthEdges(const SegmentedScan& scan, std::vector<DepthEdge>& edges);
}  // namespace psmks
