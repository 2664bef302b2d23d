/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/PolarLookup.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
/** How the end point of a ray lies to the surfaces that another scan saw at its bearing. */
enum class RayOutcome
{
  On,         //!< on the surface
  Front,      //!< in front of the surface, in space that the other scan saw free
  Behind,     //!< behind the surface: at a wrong pose, or hidden from the other viewpoint
  Uncovered,  //!< behind an object that may have gone away
  Undecided,  //!< between the near and the far side of a jump, where anything may be
  Unknown     //!< outside the field of view, or where the other scan has no surface
};

/** The outcome of a ray that ends at a point.
 *  @param cell of the surface at the bearing of the point, PolarLookup::cellOf()
 *  @param tolerance_m distance within which a point is on a surface */
inline RayOutcome outcomeOf(const PolarLookup& surface, int cell, float x_m, float y_m,
                            float tolerance_m)
{
  if (cell < 0 || !surface.known(cell)) return RayOutcome::Unknown;
  const PolarLookup::Side* sides = surface.sides(cell);
  const float a_m = sides[0].distance_m(x_m, y_m), b_m = sides[1].distance_m(x_m, y_m);
  if (std::min(std::fabs(a_m), std::fabs(b_m)) < tolerance_m) return RayOutcome::On;
  if (std::max(a_m, b_m) < 0) return RayOutcome::Front;
  if (std::min(a_m, b_m) > 0)
    return surface.movable(cell) ? RayOutcome::Uncovered : RayOutcome::Behind;
  return RayOutcome::Undecided;
}
}  // namespace psmks
