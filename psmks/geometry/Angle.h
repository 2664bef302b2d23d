/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cmath>

namespace psmks
{
/** Half a circle. Unit: rad. Definition: pi. */
constexpr double kPi = 3.14159265358979323846;

/** The angle in (-pi, pi] that points the same way. */
inline double wrapAngle(double angle_rad)
{
  if (angle_rad > -kPi && angle_rad <= kPi) return angle_rad;
  const double wrapped_rad = std::remainder(angle_rad, 2 * kPi);
  return wrapped_rad <= -kPi ? wrapped_rad + 2 * kPi : wrapped_rad;
}

/** Degrees of one radian. Unit: deg/rad. Definition: a half circle has 180 degrees and pi radians.
 */
constexpr long double kDegreesPerRadian = 180 / 3.141592653589793238462643383279502884L;

/** Converts degrees to radians. The product is computed in long double and rounded once, so that
 * the result equals the number that a text of the angle in degrees, read from a file, becomes. */
constexpr double degToRad(long double angle_deg)
{
  return static_cast<double>(angle_deg / kDegreesPerRadian);
}

constexpr double radToDeg(double angle_rad) { return angle_rad * (180 / kPi); }
}  // namespace psmks
