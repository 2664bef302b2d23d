/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>

#include <Eigen/Core>
#include <cmath>

namespace psmks
{
/** A planar pose and, at the same time, a rigid motion of the plane.
 *
 * A variable `T_a_b` is the pose of frame b seen from frame a. It maps points of frame b into frame
 * a: `p_a = T_a_b * p_b`. */
struct Pose2
{
  double x_m = 0;
  double y_m = 0;
  double phi_rad = 0;  //!< every operation below leaves it in (-pi, pi]

  Eigen::Vector2d translation() const { return {x_m, y_m}; }

  Eigen::Matrix2d rotation() const
  {
    const double c = std::cos(phi_rad), s = std::sin(phi_rad);
    return (Eigen::Matrix2d() << c, -s, s, c).finished();
  }

  /** The derivative of rotation() by phi. */
  Eigen::Matrix2d rotationDerivative() const
  {
    const double c = std::cos(phi_rad), s = std::sin(phi_rad);
    return (Eigen::Matrix2d() << -s, -c, c, -s).finished();
  }

  Eigen::Vector2d operator*(const Eigen::Vector2d& p) const
  {
    return rotation() * p + translation();
  }

  Pose2 operator*(const Pose2& T_b_c) const
  {
    const Eigen::Vector2d t = *this * T_b_c.translation();
    return {t.x(), t.y(), wrapAngle(phi_rad + T_b_c.phi_rad)};
  }

  Pose2 inverse() const
  {
    const Eigen::Vector2d t = -(rotation().transpose() * translation());
    return {t.x(), t.y(), wrapAngle(-phi_rad)};
  }

  bool isFinite() const
  {
    return std::isfinite(x_m) && std::isfinite(y_m) && std::isfinite(phi_rad);
  }
};
}  // namespace psmks
