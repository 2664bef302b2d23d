/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/MatchingError.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Smallest standard deviation of a range in the weights. Definition: below that of any scanner; it
 * keeps the weights of a simulated scan without noise finite. */
constexpr double kLeastSigma_m = 1e-3;

double leastVariance_m2(const SegmentedScan& scan)
{
  const double sigma_m = std::max(scan.typicalRangeSigma_m(), kLeastSigma_m);
  return sigma_m * sigma_m;
}

double variance_m2(const Segment& segment, const SegmentedScan& scan)
{
  return std::max(segment.sigma_m * segment.sigma_m, leastVariance_m2(scan));
}
}  // namespace

void SegmentReliability::assign(const SegmentedScan& current, const SegmentedScan& reference)
{
  referenceSegments_ = reference.segments.size();
  leastVariance_m2_ = psmks::leastVariance_m2(current) + psmks::leastVariance_m2(reference);
  pairs_.clear();
  for (const Segment& c : current.segments)
    for (const Segment& r : reference.segments)
      pairs_.push_back({static_cast<double>(c.rays + r.rays),
                        variance_m2(c, current) + variance_m2(r, reference)});
}

double matchingError(const Associations& associations, const SegmentReliability& reliability,
                     const PaperOptions& options)
{
  const double worst_m2 = options.radiusGate_m * options.radiusGate_m;
  double sum = 0, points = 0;
  for (const Association& a : associations.pairs)
  {
    const Reliability& pair = reliability.ofPair(a.currentSegment, a.referenceSegment);
    sum += pair.weight() * std::min(a.residual_m * a.residual_m, worst_m2);
    points += pair.points;
  }
  return points > 0 ? sum / points : worst_m2 / reliability.leastVariance_m2();
}

double rmsResidual_m(const Associations& associations, const SegmentReliability& reliability)
{
  double sum_m2 = 0, points = 0;
  for (const Association& a : associations.pairs)
  {
    const double n = reliability.ofPair(a.currentSegment, a.referenceSegment).points;
    sum_m2 += n * a.residual_m * a.residual_m;
    points += n;
  }
  return points > 0 ? std::sqrt(sum_m2 / points) : 0;
}
}  // namespace psmks
