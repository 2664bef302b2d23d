/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/PolarLookup.h>
#include <psmks/features/RayPoints.h>
#include <psmks/geometry/Pose2.h>

namespace psmks
{
/** How the rays of one scan stand to the surfaces of another. */
struct RayCounts
{
  int on = 0;         //!< on the surface seen at their bearing
  int front = 0;      //!< before it, in space the other scan saw free
  int behind = 0;     //!< behind it: wrong, or hidden from the other viewpoint
  int moved = 0;      //!< before it, but on a free-standing object that may have moved there
  int uncovered = 0;  //!< behind a free-standing object that may have moved away
  int unknown = 0;    //!< outside the field of view, or where the other scan has no return

  int counted() const { return on + front + behind + moved + uncovered + unknown; }

  RayCounts& operator+=(const RayCounts& o)
  {
    on += o.on, front += o.front, behind += o.behind;
    moved += o.moved, uncovered += o.uncovered, unknown += o.unknown;
    return *this;
  }
};

/** Counts every `stride`-th point of a scan, moved by T_surface_points, against the surfaces of
 * another.
 *  @param tolerance_m distance within which a point is on a surface */
RayCounts countRays(const RayPoints& points, const PolarLookup& surface,
                    const Pose2& T_surface_points, float tolerance_m, int stride = 1);

/** Share of rays explained, 0 to 1:
 *
 *     s = on / (on + front + (behind + moved) / 2 + uncovered / 4) * min(1, seen / 0.4)
 *
 * where `seen` is the share of rays that are not unknown. A ray behind counts half, for it may have
 * been hidden; so does one on an object that may have moved. A wrong pose can fit the pairs it has
 * kept, but it puts rays of walls into free space (docs/algorithm.md). */
double freeSpaceScore(const RayCounts& counts);

/** Distance within which a point is on a surface, for ranges of this noise. */
float surfaceTolerance_m(double rangeSigma_m);
}  // namespace psmks
