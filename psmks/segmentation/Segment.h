/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>

namespace psmks
{
/** A straight piece of wall that consecutive rays have seen. */
struct Segment
{
  /** The line in the sensor frame, with its covariance. */
  Line line;

  /** Index on the grid of the first ray, counter-clockwise. */
  int firstRay = 0;

  /** Index on the grid of the last ray. It is below `firstRay` where the segment crosses the seam
   * of a closed scan. */
  int lastRay = 0;

  /** Number of rays that belong to the segment. Isolated outliers between its ends do not. */
  int rays = 0;

  /** Standard deviation of the range residuals at the middle of the segment, estimated with
   * `rays - 2` degrees of freedom. */
  double sigma_m = 0;

  /** The points of the line at the bearings of the first and of the last ray, in the sensor frame.
   */
  Eigen::Vector2d firstEnd_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d lastEnd_m = Eigen::Vector2d::Zero();

  double length_m() const { return (lastEnd_m - firstEnd_m).norm(); }
};
}  // namespace psmks
