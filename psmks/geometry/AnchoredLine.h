/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>

namespace psmks
{
/** A line written so that its two errors are independent: as the point of the line at which the
 * errors of distance and angle are uncorrelated (the anchor), and the normal there
 * (docs/derivations.md, "Residuals of two lines"). */
struct AnchoredLine
{
  Eigen::Vector2d normal;  //!< away from the scanner
  Eigen::Vector2d along;   //!< unit vector, counter-clockwise
  Eigen::Vector2d anchor_m;
  double distance_m = 0;  //!< distance of the line from the origin
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

  /** Variance of the distance between the line and a point near it: the variance of the line's
   * distance plus that of its angle times the squared way from the anchor. */
  double distanceVarianceAt_m2(const Eigen::Vector2d& p_m) const
  {
    const double along_m = along.dot(p_m - anchor_m);
    return distanceVariance_m2 + along_m * along_m * angleVariance_rad2;
  }
};
}  // namespace psmks
