/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Line.h>

#include <limits>

namespace psmks
{
double Line::rangeAt_m(double bearing_rad) const
{
  const double cosine = std::cos(bearing_rad - phi0_rad);
  return cosine > 0 ? r0_m / cosine : std::numeric_limits<double>::infinity();
}

double Line::distanceVariance_m2(double along_m) const
{
  return covariance(0, 0) - 2 * along_m * covariance(0, 1) + along_m * along_m * covariance(1, 1);
}

Line Line::fromNormalForm(double signedR0_m, double phi0_rad, const Eigen::Matrix2d& covariance,
                          bool* flipped)
{
  const bool flip = signedR0_m < 0;
  if (flipped) *flipped = flip;
  if (!flip) return {signedR0_m, wrapAngle(phi0_rad), covariance};
  Eigen::Matrix2d turned = covariance;
  turned(0, 1) = -covariance(0, 1);
  turned(1, 0) = -covariance(1, 0);
  return {-signedR0_m, wrapAngle(phi0_rad + kPi), turned};
}

Line Line::transformed(const Pose2& T_to_from, bool* flipped) const
{
  // phi0' = phi0 + theta,  r0' = r0 + x cos phi0' + y sin phi0'
  const double phi0_to_rad = phi0_rad + T_to_from.phi_rad;
  const double c = std::cos(phi0_to_rad), s = std::sin(phi0_to_rad);
  const double r0_to_m = r0_m + T_to_from.x_m * c + T_to_from.y_m * s;
  Eigen::Matrix2d J;
  J << 1, -T_to_from.x_m * s + T_to_from.y_m * c, 0, 1;
  return fromNormalForm(r0_to_m, phi0_to_rad, J * covariance * J.transpose(), flipped);
}
}  // namespace psmks
