/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>

namespace psmks
{
/** A line in the form that separates its errors: at the anchor, the errors of distance and angle
 * are independent (docs/algorithm.md, residuals of two lines). */
struct AnchoredLine
{
  Eigen::Vector2d normal;  //!< away from the scanner
  Eigen::Vector2d along;   //!< unit vector, counter-clockwise
  Eigen::Vector2d anchor_m;
  double distance_m = 0;  //!< of the line from the origin
  double distanceVariance_m2 = 0, angleVariance_rad2 = 0;

  AnchoredLine() = default;
  explicit AnchoredLine(const Line& line)
      : normal(line.normal()), along(-normal.y(), normal.x()), distance_m(line.r0_m)
  {
    // The distance error at `along` from the foot is along d(phi0) - d(r0): independent of d(phi0)
    // at along = cov(r0, phi0) / var(phi0).
    const Eigen::Matrix2d& P = line.covariance;
    const double along_m = P(1, 1) > 0 ? P(0, 1) / P(1, 1) : 0;
    anchor_m = line.r0_m * normal + along_m * along;
    distanceVariance_m2 = line.distanceVariance_m2(along_m);
    angleVariance_rad2 = P(1, 1);
  }

  /** Variance of the distance of the line at a point near it. */
  double distanceVarianceAt_m2(const Eigen::Vector2d& p_m) const
  {
    const double along_m = along.dot(p_m - anchor_m);
    return distanceVariance_m2 + along_m * along_m * angleVariance_rad2;
  }
};
}  // namespace psmks
