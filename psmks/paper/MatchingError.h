/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/Association.h>

#include <vector>

namespace psmks
{
/** How much the residuals of a segment are worth. The more points a segment has and the closer they
 * lie to the line, the more its residuals count. */
struct Reliability
{
  double points = 0;       //!< n, the number of points
  double variance_m2 = 1;  //!< s^2, the variance of a range residual, at least that of the scanner

  /** The weight of a squared residual: in proportion to the points, in inverse proportion to the
   * variance. */
  double weight() const { return points / variance_m2; }
};

/** The reliabilities of all pairs of segments of two scans.
 *
 * Differs from the paper: the standard deviation of a segment is at least that of the scanner,
 * where the paper takes it as estimated from the points. The estimate from six points may be a
 * third of the truth by chance, and such a segment would outweigh a long wall. */
class SegmentReliability
{
 public:
  void assign(const SegmentedScan& current, const SegmentedScan& reference);

  /** The sum s_cur^2 + s_ref^2 for two segments as certain as the scanners allow. */
  double leastVariance_m2() const { return leastVariance_m2_; }

  /** The reliability of a pair of segments: the sum of their points and the sum of their variances.
   */
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
 *  with n = n_cur + n_ref, s^2 = s_cur^2 + s_ref^2 and g = radiusGate_m. f has no unit and is about
 * 1 or less at the true pose. Rays without an association do not contribute, so only poses with
 *  similar numbers of associations can be compared by f, see PoseObjective::isBetter().
 *
 *  @return the error as defined; without associations its upper bound g^2 / s^2, s of the scanners
 */
double matchingError(const Associations& associations, const SegmentReliability& reliability,
                     const PaperOptions& options);

/** The root of the weighted mean of the squared residuals of the associated rays, where a ray
 * counts as many times as its segments have points; 0 without associations. */
double rmsResidual_m(const Associations& associations, const SegmentReliability& reliability);
}  // namespace psmks
