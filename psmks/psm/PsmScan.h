/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/psm/PsmOptions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace psmks
{
/** Whether a ray takes part. The method also has tags for moving objects and for readings on an
 *  edge, but no rule that sets them: a reading on an edge drops out as a lone point. */
enum class PsmTag : std::uint8_t
{
  Good,
  BeyondRange,  //!< no usable reading
  Occluded,     //!< projected: its surface is seen from behind
  Empty         //!< projected: no surface at this bearing
};

/** A scan ready for polar scan matching: filtered, tagged and segmented. */
struct PsmScan
{
  /** Segment of a point on no surface, and of a ray without a reading. Unit: index. Definition:
   * real segments count from 1. */
  static constexpr int kNoSurface = 0;

  BeamGrid grid;
  double maxRange_m = 0;        //!< infinite where there is no limit
  std::vector<double> range_m;  //!< one per ray; infinite where BeyondRange
  std::vector<PsmTag> tag;      //!< one per ray: Good or BeyondRange
  std::vector<int> segment;     //!< one per ray: kNoSurface, or the number of a surface, from 1

  int rays() const { return static_cast<int>(range_m.size()); }
  bool isGood(int i) const { return tag[static_cast<std::size_t>(i)] == PsmTag::Good; }
  double range(int i) const { return range_m[static_cast<std::size_t>(i)]; }
  int segmentOf(int i) const { return segment[static_cast<std::size_t>(i)]; }

  /** True where rays i and j lie on one surface. */
  bool sameSurface(int i, int j) const
  {
    return segmentOf(i) != kNoSurface && segmentOf(i) == segmentOf(j);
  }

  /** A good ray's point in the sensor frame. */
  Eigen::Vector2d point(int i) const { return range(i) * grid.direction(i); }

  int goodRays() const;
};

/** Median filter, tags and segments of a scan (Diosi and Kleeman 2007).
 *
 *  A ray without a reading (NaN, infinite, not positive, flagged, at or beyond the maximum range)
 *  counts as farther than any in the median, so that a single one between readings takes their
 *  median, and a single reading between such rays disappears. The ends of an open scan are repeated
 *  for the filter; a closed one has none.
 *
 *  Never fails: a scan whose ranges do not fit its grid has no good ray. */
void preparePsmScan(const Scan& scan, const PsmOptions& options, PsmScan& result);
}  // namespace psmks
