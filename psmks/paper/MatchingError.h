/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/Association.h>

#include <vector>

namespace psmks
{
/** How far a segment can be relied on: many points, close to a straight line. */
struct Reliability
{
  double points = 0;       //!< n
  double variance_m2 = 1;  //!< s^2, of one range residual: no less than the scanner's

  /** Of one squared residual: proportional to the points, inverse to the variance. */
  double weight() const { return points / variance_m2; }
};

/** Reliabilities of all pairs of segments of two scans.
 *
 * Differs from the paper: it takes a segment's standard deviation as estimated. That of six rays
 * may come out at a third of the truth by chance, and the segment would then outweigh a long wall.
 */
class SegmentReliability
{
 public:
  void assign(const SegmentedScan& current, const SegmentedScan& reference);

  /** Of two segments as certain as the scanners allow: s_cur^2 + s_ref^2. */
  double leastVariance_m2() const { return leastVariance_m2_; }

  /** Of a pair: the points of both, the variances of both. */
  const Reliability& ofPair(int currentSegment, int referenceSegment) const
  {
    return pairs_[static_cast<std::size_t>(currentSegment) * referenceSegments_ +
                  static_cast<std::size_t>(referenceSegment)];
  }

 private:
  std::vector<Reliability> pairs_;
  double leastVariance_m2_ = 1;
  std::size_t referenceSegments_ = 0;
};

/** The matching error f of a pose (paper, section 2.2): squared residuals, weighted by the
 *  reliability of their segments, as a weighted mean over the associated rays
 *
 *      f = sum n_i min(e_i, g)^2 / s_i^2  /  sum n_i
 *
 *  with n = n_cur + n_ref, s^2 = s_cur^2 + s_ref^2 and g = radiusGate_m. f has no unit; at the true
 *  pose it is about 1 or less. It says nothing about rays that lost their associate, so it compares
 *  poses of about as many associated rays and no others: see PoseObjective::isBetter().
 *
 *  @return where nothing is associated the worst there is: g^2 / s^2 of the scanners */
double matchingError(const Associations& associations, const SegmentReliability& reliability,
                     const PaperOptions& options);

/** Root of the mean squared residual of the associated rays, weighted by the points of their
 *  segments. 0 where nothing is associated. */
double rmsResidual_m(const Associations& associations, const SegmentReliability& reliability);
}  // namespace psmks
