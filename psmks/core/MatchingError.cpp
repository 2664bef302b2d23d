/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/MatchingError.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** No scanner's rays are more certain than this; keeps the weights of an exact scan finite. */
constexpr double kLeastSigma_m = 1e-3;

double variance_m2(const Segment& segment)
{
  return std::max(segment.sigma_m * segment.sigma_m, kLeastSigma_m * kLeastSigma_m);
}

Reliability reliabilityOf(const Segment& a, const Segment& b)
{
  return {static_cast<double>(a.rays + b.rays), variance_m2(a) + variance_m2(b)};
}
}  // namespace

void SegmentReliability::assign(const SegmentedScan& current, const SegmentedScan& reference)
{
  referenceSegments_ = reference.segments.size();
  pairs_.clear();
  alone_.clear();
  for (const Segment& c : current.segments)
  {
    alone_.push_back(reliabilityOf(c, c));
    for (const Segment& r : reference.segments) pairs_.push_back(reliabilityOf(c, r));
  }
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
  for (std::size_t c = 0; c < associations.tallies.size(); ++c)
  {
    const RayTally& tally = associations.tallies[c];
    if (tally.refused == 0) continue;
    const Reliability& alone = reliability.alone(static_cast<int>(c));
    const double counted = tally.refused * tally.refusedShare();
    sum += counted * alone.weight() * worst_m2;
    points += counted * alone.points;
  }
  return points > 0 ? sum / points : 0;
}
}  // namespace psmks
