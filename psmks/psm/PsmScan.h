/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/psm/PsmOptions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace psmks
{
/** Whether a ray is used. The source also names tags for moving objects and for mixed readings at
 * edges, but gives no rule that sets them: a mixed reading is dropped as a point without surface.
 */
enum class PsmTag : std::uint8_t
{
  Good,
  BeyondRange,  //!< no usable reading
  Occluded,     //!< projected: its surface is seen from behind
  Empty         //!< projected: no surface at this bearing
};

/** A scan prepared for polar scan matching: filtered, tagged and segmented. */
struct PsmScan
{
  /** The segment of rays that lie on no surface or have no reading. */
  static constexpr int kNoSurface = 0;

  BeamGrid grid;
  double maxRange_m = 0;        //!< infinite if there is no limit
  std::vector<double> range_m;  //!< one per ray; infinite if the tag is BeyondRange
  std::vector<PsmTag> tag;      //!< one per ray: Good or BeyondRange
  std::vector<int> segment;     //!< one per ray: kNoSurface, or the number of a surface, from 1

  int rays() const { return static_cast<int>(range_m.size()); }
  bool isGood(int i) const { return tag[static_cast<std::size_t>(i)] == PsmTag::Good; }
  double range(int i) const { return range_m[static_cast<std::size_t>(i)]; }
  int segmentOf(int i) const { return segment[static_cast<std::size_t>(i)]; }

  /** Whether rays i and j lie on one surface. */
  bool sameSurface(int i, int j) const
  {
    return segmentOf(i) != kNoSurface && segmentOf(i) == segmentOf(j);
  }

  /** The end point of ray i in the sensor frame. The ray has to be Good. */
  Eigen::Vector2d point(int i) const { return range(i) * grid.direction(i); }

  int goodRays() const;
};

/** Median filter, tags and segments of a scan (Diosi and Kleeman 2007).
 *
 *  For the median, a ray without a reading (NaN, infinite, not positive, flagged, at or beyond the
 *  maximum range) counts as farther than all readings: a single such ray between readings gets
 *  their median, and a single reading between such rays is removed. At the ends of an open scan the
 *  filter repeats the outer readings; on a closed scan it wraps.
 *
 *  It never fails: if the number of ranges differs from that of the grid, no ray is Good. */
void preparePsmScan(const Scan& scan, const PsmOptions& options, PsmScan& result);
}  // namespace psmks
