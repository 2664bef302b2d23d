/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cmath>

namespace psmks
{
/** atan2(y, x) within 1.2e-5 rad, without branches: enough to find the ray at a bearing, several
 * times faster than the library's. The odd polynomial is the minimax fit of atan on [0, 1] (least
 * squares reweighted by its own error, docs/algorithm.md). (0, 0) gives 0. */
inline float fastBearing_rad(float y, float x)
{
  constexpr float kHalfPi = 1.57079632679f, kPiF = 3.14159265359f;
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  const float t = small / (large > 1e-30f ? large : 1e-30f);
  const float t2 = t * t;
  float a = t * (0.99986633f +
                 t2 * (-0.33030472f + t2 * (0.18015899f + t2 * (-0.08515587f + t2 * 0.02084487f))));
  a = ay > ax ? kHalfPi - a : a;
  a = x < 0 ? kPiF - a : a;
  return y < 0 ? -a : a;
}
}  // namespace psmks
