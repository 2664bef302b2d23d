/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** A straight line in polar form: the points p with n.p = r0, n = (cos phi0, sin phi0).
 *
 *              line
 *               |            r0    distance of the line from the origin, >= 0
 *   origin o----+ foot       phi0  direction from the origin to the foot, in (-pi, pi]
 *           r0  |
 *
 * A ray at bearing b meets it at range r0 / cos(b - phi0) (paper, section 2.1). */
struct Line
{
  double r0_m = 0;
  double phi0_rad = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  //!< of (r0, phi0): m^2, m rad, rad^2

  Eigen::Vector2d normal() const { return {std::cos(phi0_rad), std::sin(phi0_rad)}; }

  /** Signed distance of a point: positive beyond the line, seen from the origin. */
  double distance_m(const Eigen::Vector2d& p) const { return normal().dot(p) - r0_m; }

  /** Range at which a ray meets the line; +infinity where the ray does not (it runs along the line
   * or away from it). */
  double rangeAt_m(double bearing_rad) const;

  /** Variance of distance_m() of a point on the line that lies `along_m` metres from the foot, on
   * the counter-clockwise side: the error of the line there is along * d(phi0) - d(r0). */
  double distanceVariance_m2(double along_m) const;

  /** The same line seen from another frame, with its covariance (algorithm.md, C1).
   *  @param T_to_from maps points of the line's present frame into the wanted one
   *  @param flipped set to true when the line is then seen from its other side (may be null) */
  Line transformed(const Pose2& T_to_from, bool* flipped = nullptr) const;

  /** The line through n.p = r0 where r0 may be negative: folded to r0 >= 0. */
  static Line fromNormalForm(double signedR0_m, double phi0_rad, const Eigen::Matrix2d& covariance,
                             bool* flipped = nullptr);
};
}  // namespace psmks
