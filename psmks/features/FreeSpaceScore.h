/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/PolarLookup.h>
#include <psmks/features/RayPoints.h>
#include <psmks/geometry/Pose2.h>

namespace psmks
{
/** How many end points of one scan lie on, in front of and behind the surfaces that another scan
 * saw at their bearings. */
struct RayCounts
{
  int on = 0;         //!< on the surface
  int front = 0;      //!< in front of the surface, in space that the other scan saw free
  int behind = 0;     //!< behind the surface: at a wrong pose, or hidden from the other viewpoint
  int moved = 0;      //!< in front of the surface, on a movable object that may have come there
  int uncovered = 0;  //!< behind a movable object that may have gone away
  int unknown = 0;    //!< outside the field of view, or where the other scan has no return

  int counted() const { return on + front + behind + moved + uncovered + unknown; }

  RayCounts& operator+=(const RayCounts& o)
  {
    on += o.on, front += o.front, behind += o.behind;
    moved += o.moved, uncovered += o.uncovered, unknown += o.unknown;
    return *this;
  }
};

/** Counts the points of one scan against the surfaces of another.
 *  @param T_surface_points maps the points into the frame of the surfaces
 *  @param tolerance_m distance within which a point is on a surface
 *  @param stride every so many points are counted */
RayCounts countRays(const RayPoints& points, const PolarLookup& surface,
                    const Pose2& T_surface_points, float tolerance_m, int stride = 1);

/** How well a pose explains the rays, 0 to 1: a weighted share of the rays that the other scan
 *  could judge, 1 where all of them lie on its surfaces (docs/derivations.md, "Free-space score"):
 *
 *      s = on / (on + front + (behind + moved) / 2 + uncovered / 4) * min(1, seen / 0.4)
 *
 *  where `seen` is the share of the rays that are not unknown; unknown rays lower the score only
 *  where fewer than 40 % are seen. A ray behind the surface counts half, because it may have been
 *  hidden; so does a ray on an object that may have moved. A wrong pose can fit the pairs that it
 *  has kept, but it puts rays of walls into free space. */
double freeSpaceScore(const RayCounts& counts);

/** Distance within which a point counts as on a surface: three standard deviations of a range and 1
 * cm, and 4 cm at least. */
float surfaceTolerance_m(double rangeSigma_m);
}  // namespace psmks
