/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>

namespace psmks
{
/** A straight piece of wall seen by consecutive rays. */
struct Segment
{
  Line line;           //!< in the sensor frame, with its covariance
  int firstRay = 0;    //!< index on the grid
  int lastRay = 0;     //!< below firstRay where the segment crosses the seam of a closed scan
  int rays = 0;        //!< rays that belong to it (isolated outliers between its ends do not)
  double sigma_m = 0;  //!< standard deviation of the range residuals at its middle, with rays - 2
                       //!< degrees of freedom
  Eigen::Vector2d firstEnd_m = Eigen::Vector2d::Zero();  //!< the line at the bearing of firstRay
  Eigen::Vector2d lastEnd_m = Eigen::Vector2d::Zero();   //!< the line at the bearing of lastRay

  double length_m() const { return (lastEnd_m - firstEnd_m).norm(); }
};
}  // namespace psmks
