/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Association.h>

#include <vector>

namespace psmks
{
/** How far a segment can be relied on: many points, close to a straight line. */
struct Reliability
{
  double points = 0;       //!< n
  double variance_m2 = 1;  //!< s^2, of one range residual

  /** Of one squared residual: proportional to the points, inverse to the variance. */
  double weight() const { return points / variance_m2; }
};

/** Reliabilities of all pairs of segments of two scans. */
class SegmentReliability
{
 public:
  void assign(const SegmentedScan& current, const SegmentedScan& reference);

  /** Of a pair: the points of both, the variances of both. */
  const Reliability& ofPair(int currentSegment, int referenceSegment) const
  {
    return pairs_[static_cast<std::size_t>(currentSegment) * referenceSegments_ +
                  static_cast<std::size_t>(referenceSegment)];
  }

  /** Of a current segment and a reference segment like it. */
  const Reliability& alone(int currentSegment) const
  {
    return alone_[static_cast<std::size_t>(currentSegment)];
  }

 private:
  std::vector<Reliability> pairs_, alone_;
  std::size_t referenceSegments_ = 0;
};

/** The matching error f of a pose (paper, section 2.2): squared residuals, weighted by the
 *  reliability of their segments, as a weighted mean
 *
 *      f = sum n_i min(e_i, g)^2 / s_i^2  /  sum n_i
 *
 *  with n = n_cur + n_ref, s^2 = s_cur^2 + s_ref^2, the sums over every ray that could be compared,
 *  and e = g = radiusGate_m for those that the gate refused. Each of these counts by the share of
 *  its segment's rays that were refused. f has no unit; at the true pose it is about 1 or less.
 *
 *  Differs from the paper: that leaves open how errors over different numbers of rays compare. A
 *  plain mean over the associated rays falls whenever a badly fitting pair is lost, so a pose that
 *  associates less would win. Here losing a pair never pays. The share keeps f smooth: the ray or
 *  two of a good segment that slip round a corner as the pose changes hardly count.
 *
 *  @return 0 where nothing can be compared */
double matchingError(const Associations& associations, const SegmentReliability& reliability,
                     const PaperOptions& options);
}  // namespace psmks
