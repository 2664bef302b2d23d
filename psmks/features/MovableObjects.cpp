/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/MovableObjects.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** Depth between a movable object and what stands behind it, at least. Evidence: measured. */
constexpr double kJump_m = 0.3;

/** Width of a movable object, at most: a person with a bag. Evidence: measured. */
constexpr double kWidest_m = 0.8;

/** Whether the ray beside the end of an object sees clearly farther than the end. A ray without a
 * return counts as far.
 *  @param end last ray of the object on this side
 *  @param beyond the ray beside it, or -1 at the end of the field of view */
bool dropsBehind(const SegmentedScan& scan, int end, int beyond)
{
  if (beyond < 0) return false;  // what is beyond the field of view may be as near
  return !scan.isValid(beyond) || scan.range_m[static_cast<std::size_t>(beyond)] >
                                      scan.range_m[static_cast<std::size_t>(end)] + kJump_m;
}

/** Whether two neighbouring rays are on one object.
 *  @param b index of the second ray, or -1 at the end of the field of view */
bool joined(const SegmentedScan& scan, int a, int b)
{
  return b >= 0 && scan.isValid(b) &&
         std::abs(scan.range_m[static_cast<std::size_t>(a)] -
                  scan.range_m[static_cast<std::size_t>(b)]) <= kJump_m;
}

/** Flags the rays of the object that begins at a ray, if it is narrow and what is beyond its other
 * end is clearly farther.
 *  @param first a ray beside which dropsBehind() */
void flagObject(const SegmentedScan& scan, int first, std::vector<std::uint8_t>& movable)
{
  const Eigen::Vector2d first_m = scan.point_m(first);
  int last = first, rays = 1;
  for (int next = scan.nextReturn(last, 1); rays < scan.rays() && joined(scan, last, next);
       next = scan.nextReturn(last, 1), ++rays)
  {
    last = next;
    if ((scan.point_m(last) - first_m).squaredNorm() > kWidest_m * kWidest_m) return;
  }
  if (!dropsBehind(scan, last, scan.nextReturn(last, 1))) return;
  for (int ray = first; rays > 0; ray = scan.nextReturn(ray, 1), --rays)
    movable[static_cast<std::size_t>(ray)] = 1;
}
}  // namespace

void findMovableObjects(const SegmentedScan& scan, std::vector<std::uint8_t>& movable)
{
  movable.assign(static_cast<std::size_t>(scan.rays()), 0);
  for (int first = 0; first < scan.rays(); ++first)
  {
    if (!scan.isValid(first)) continue;
    if (dropsBehind(scan, first, scan.nextReturn(first, -1))) flagObject(scan, first, movable);
    // An object does not begin within a segment.
    if (const Segment* segment = scan.segmentAt(first)) first = scan.rayAfter(*segment, first) - 1;
  }
}
}  // namespace psmks
