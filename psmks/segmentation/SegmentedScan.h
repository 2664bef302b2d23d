/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>
#include <psmks/geometry/RangeNoise.h>
#include <psmks/segmentation/Segment.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace psmks
{
/** A scan after preprocessing and Kalman Segmentation, which the matching schemes work on. */
struct SegmentedScan
{
  /** Stands in segmentOfRay for a ray without a segment. Unit: index. Definition: no index is
   * negative. */
  static constexpr int kNoSegment = -1;

  /** The bearings of the rays. */
  BeamGrid grid;

  /** One range per ray; 0 where the ray is invalid, finite and positive elsewhere. */
  std::vector<double> range_m;

  /** One flag per ray, 0 or 1. */
  std::vector<std::uint8_t> valid;

  /** Noise that the lines were found with. */
  RangeNoise rangeNoise;

  /** Noise that the scan itself shows. Clutter looks like noise, see ScannerNoise. */
  RangeNoise shownNoise;

  /** Whether `shownNoise` is more than the stated noise with that of rounding. */
  bool showsMoreNoise = false;

  /** Usual distance between neighbouring returns, in rays: 1 where most returns have one beside
   * them, more in a sparse scan. */
  int returnSpacing = 1;

  /** How many neighbouring rays tell as much as one whose error is independent of the others: 1 for
   * white noise. Scanners smooth along a scan, and walls are uneven over more than one ray. The
   * covariances of the segments count it. */
  double raysPerReading = 1;

  /** Readings at or beyond it are no returns. */
  double maxRange_m = std::numeric_limits<double>::infinity();

  /** As in Scan. */
  double stamp_s = 0;

  /** The segments, in the order of their first rays. */
  std::vector<Segment> segments;

  /** Index into `segments` for each ray, or kNoSegment. */
  std::vector<int> segmentOfRay;

  /** Most invalid rays in a row that leave a surface whole; 0 where the scan is not sparse. */
  int longestHole() const
  {
    /** Longest hole in a surface. Unit: usual distances between returns. Evidence: measured. */
    constexpr int kDistances = 3;
    return returnSpacing > 1 ? kDistances * returnSpacing : 0;
  }

  int rays() const { return grid.count(); }
  int validRays() const;
  bool hasValidRay() const;
  bool isValid(int ray) const { return valid[static_cast<std::size_t>(ray)] != 0; }

  /** Variance of the range of a valid ray by `rangeNoise`. */
  double rangeVarianceOf_m2(int ray) const
  {
    return rangeNoise.varianceAt_m2(range_m[static_cast<std::size_t>(ray)]);
  }

  /** Standard deviation of a range by `rangeNoise`: root mean square over the valid rays. */
  double typicalRangeSigma_m() const { return typicalSigma_m(rangeNoise); }

  /** Standard deviation of a range by `shownNoise`: root mean square over the valid rays. */
  double shownRangeSigma_m() const { return typicalSigma_m(shownNoise); }

  /** The next ray to one side that has a return, across a hole of at most longestHole() rays; where
   *  there is none, the ray beside, or -1 outside the field of view.
   *  @param step +1 or -1 */
  int nextReturn(int ray, int step) const
  {
    int next = grid.neighbour(ray, step);
    for (int hole = 1; hole <= longestHole() && next >= 0 && !isValid(next); ++hole)
      next = grid.neighbour(ray, step * (hole + 1));
    return next >= 0 && isValid(next) ? next : grid.neighbour(ray, step);
  }

  /** Measured end point of a valid ray, in the sensor frame. */
  Eigen::Vector2d point_m(int ray) const
  {
    return range_m[static_cast<std::size_t>(ray)] * grid.direction(ray);
  }

  /** The segment that a ray belongs to, or null. */
  const Segment* segmentAt(int ray) const
  {
    const int s = segmentOfRay[static_cast<std::size_t>(ray)];
    return s == kNoSegment ? nullptr : &segments[static_cast<std::size_t>(s)];
  }

  /** The first ray after a segment, for a loop over the rays that skips it.
   *  @param ray a ray between the ends of the segment
   *  @return its index; rays() where the segment goes on across the seam of a closed scan */
  int rayAfter(const Segment& segment, int ray) const
  {
    return segment.lastRay < ray ? rays() : segment.lastRay + 1;
  }

  /** Range of a ray on the line of its segment, which is free of the ray's own noise; the measured
   * range where the ray has no segment. */
  double denoisedRange_m(int ray) const;

 private:
  double typicalSigma_m(const RangeNoise& noise) const;
};
}  // namespace psmks
