/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cmath>

namespace psmks
{
/** An approximation of atan2(y, x) without branches, for finding the ray at a bearing. It is
 * several times faster than std::atan2 and off by at most 1.2e-5 rad. The odd polynomial is the
 * minimax fit of atan on [0, 1], found by least squares with weights that follow its own error
 * (docs/derivations.md, "Fast bearings").
 *  @return the bearing in [-pi, pi]; 0 at (0, 0) */
inline float fastBearing_rad(float y, float x)
{
  /** A quarter and a half of a circle. Unit: rad. Definition: pi / 2 and pi as floats. */
  constexpr float kHalfPi = 1.57079632679f, kPiF = 3.14159265359f;

  /** Smallest divisor. Unit: m. Definition: keeps the quotient finite where both coordinates are 0.
   */
  constexpr float kSmallest_m = 1e-30f;

  const float ax = std::fabs(x), ay = std::fabs(y);
  const float large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  const float t = small / (large > kSmallest_m ? large : kSmallest_m);
  const float t2 = t * t;
  float a = t * (0.99986633f +
                 t2 * (-0.33030472f + t2 * (0.18015899f + t2 * (-0.08515587f + t2 * 0.02084487f))));
  a = ay > ax ? kHalfPi - a : a;
  a = x < 0 ? kPiF - a : a;
  return y < 0 ? -a : a;
}
}  // namespace psmks
