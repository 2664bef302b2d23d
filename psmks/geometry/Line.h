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

  /** The signed distance of a point from the line: positive if the point lies on the other side of
   * the line than the origin. */
  double distance_m(const Eigen::Vector2d& p) const { return normal().dot(p) - r0_m; }

  /** The range at which a ray meets the line, or +infinity if it does not: the ray then runs along
   * the line or away from it. */
  double rangeAt_m(double bearing_rad) const;

  /** Variance of distance_m() of a point on the line. The error of the line there is along_m *
   * d(phi0) - d(r0).
   *  @param along_m of the point from the foot, positive on the counter-clockwise side */
  double distanceVariance_m2(double along_m) const;

  /** The same line seen from another frame, with its covariance (docs/derivations.md, "Lines").
   *  @param T_to_from maps points of the present frame of the line into the new frame
   *  @param flipped if not null, set to whether the new frame sees the line from its other side */
  Line transformed(const Pose2& T_to_from, bool* flipped = nullptr) const;

  /** The line of the points p with n.p = r0, where r0 may be negative. A negative r0 is made
   * positive by turning the normal n round.
   *  @param flipped if not null, set to whether the normal was turned round */
  static Line fromNormalForm(double signedR0_m, double phi0_rad, const Eigen::Matrix2d& covariance,
                             bool* flipped = nullptr);
};
}  // namespace psmks
