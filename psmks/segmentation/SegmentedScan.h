/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>
#include <psmks/geometry/RangeNoise.h>
#include <psmks/segmentation/Segment.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** A scan after preprocessing and Kalman Segmentation: what a matcher works on.
 *
 * Segments stand in the order of their first rays. */
struct SegmentedScan
{
  /** Stands in segmentOfRay for a ray without a segment. Unit: index. Definition: no index is
   * negative. */
  static constexpr int kNoSegment = -1;

  BeamGrid grid;
  std::vector<double> range_m;      //!< one per ray; 0 where invalid, finite and positive elsewhere
  std::vector<std::uint8_t> valid;  //!< one per ray
  RangeNoise rangeNoise;            //!< the one that lines were found with
  RangeNoise shownNoise;            //!< the one that the scan shows; clutter looks like it
  bool showsMoreNoise = false;      //!< shownNoise is clearly more than stated, with rounding
  double maxRange_m = 0;            //!< as in Scan
  double stamp_s = 0;
  std::vector<Segment> segments;
  std::vector<int> segmentOfRay;  //!< index into segments, or kNoSegment

  int rays() const { return grid.count(); }
  int validRays() const;
  bool hasValidRay() const;
  bool isValid(int ray) const { return valid[static_cast<std::size_t>(ray)] != 0; }

  double rangeVarianceOf_m2(int ray) const
  {
    return rangeNoise.varianceAt_m2(range_m[static_cast<std::size_t>(ray)]);
  }

  /** Standard deviation of a range: root mean square over the valid rays. */
  double typicalRangeSigma_m() const { return typicalSigma_m(rangeNoise); }

  /** The same by the noise that the scan shows. */
  double shownRangeSigma_m() const { return typicalSigma_m(shownNoise); }

  /** The measured end point of a valid ray. */
  Eigen::Vector2d point_m(int ray) const
  {
    return range_m[static_cast<std::size_t>(ray)] * grid.direction(ray);
  }

  /** The segment of a ray, or null. */
  const Segment* segmentAt(int ray) const
  {
    const int s = segmentOfRay[static_cast<std::size_t>(ray)];
    return s == kNoSegment ? nullptr : &segments[static_cast<std::size_t>(s)];
  }

  /** The first ray beyond a segment that a ray of it is on, going up; rays() where the segment goes
   * on across the seam. */
  int rayAfter(const Segment& segment, int ray) const
  {
    return segment.lastRay < ray ? rays() : segment.lastRay + 1;
  }

  /** Range on the segment's line where the ray has one (de-noised), else the measured range. */
  double denoisedRange_m(int ray) const;

 private:
  double typicalSigma_m(const RangeNoise& noise) const;
};
}  // namespace psmks
