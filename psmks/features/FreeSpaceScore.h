/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/PolarLookup.h>
#include <psmks/features/RayPoints.h>
#include <psmks/geometry/Pose2.h>

namespace psmks
{
/** How much of what one scan saw lies on, in front of and behind the surfaces that another scan saw
 * at the same bearings, in independent looks (RayPoints::looks). */
struct RayCounts
{
  float on = 0;         //!< on the surface
  float front = 0;      //!< in front of the surface, in space that the other scan saw free
  float behind = 0;     //!< behind the surface: at a wrong pose, or hidden from the other viewpoint
  float moved = 0;      //!< in front of the surface, on a movable object that may have come there
  float uncovered = 0;  //!< behind a movable object that may have gone away
  float unknown = 0;    //!< outside the field of view, or where the other scan has no return

  /** All looks, unknown ones too. */
  float looks() const { return on + front + behind + moved + uncovered + unknown; }

  int raysOn = 0;  //!< rays that end on the surface
  int rays = 0;    //!< all rays that were counted

  RayCounts& operator+=(const RayCounts& o)
  {
    on += o.on, front += o.front, behind += o.behind;
    moved += o.moved, uncovered += o.uncovered, unknown += o.unknown;
    raysOn += o.raysOn, rays += o.rays;
    return *this;
  }
};

/** Counts the points of one scan against the surfaces of another.
 *  @param T_surface_points maps the points into the frame of the surfaces
 *  @param tolerance_m distance within which a point is on a surface
 *  @param stride every so many points are counted */
RayCounts countRays(const RayPoints& points, const PolarLookup& surface,
                    const Pose2& T_surface_points, float tolerance_m, int stride = 1);

/** What the rays say for a pose, in nat: the logarithm of how much more likely they are at the
 * right pose than at a wrong one that has been found by a search, every independent look by itself:
 *
 *      L = 0.6 (on - c),   c = 4 front + behind + (moved + uncovered) / 4
 *
 *  A look on a surface speaks for the pose; one in space that was seen free speaks against it four
 *  times as much, for walls do not come and go. A look that may have been hidden speaks against it
 *  once, and one on an object that may have moved a quarter. What the other scan could not see
 *  says nothing. Where there are more than 50 looks, the sum is that of 50 of them on average: a
 *  place as a whole looks like another one or does not. docs/derivations.md, "Likelihood of the
 * rays", has the frequencies. */
double logLikelihoodRatio(const RayCounts& counts);

/** How well a pose explains the rays, 0 to 1: the share of what speaks for it in what speaks for it
 *  and against it,
 *
 *      s = on / (on + c) * min(1, seen / 0.4)
 *
 *  with c of logLikelihoodRatio(), and `seen` the share of the looks that are not unknown: unknown
 *  ones lower the score only where fewer than 40 % are seen. It is 1 where all looks lie on
 *  surfaces, and 1/2 where as much speaks against the pose as for it. */
double freeSpaceScore(const RayCounts& counts);

/** Distance within which a point counts as on a surface: three standard deviations of a range and 1
 * cm, and 4 cm at least. */
float surfaceTolerance_m(double rangeSigma_m);
}  // namespace psmks
