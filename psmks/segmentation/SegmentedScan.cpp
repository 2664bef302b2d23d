/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/SegmentedScan.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
int SegmentedScan::validRays() const
{
  return static_cast<int>(std::count_if(valid.begin(), valid.end(), [](auto v) { return v != 0; }));
}

bool SegmentedScan::hasValidRay() const
{
  return std::any_of(valid.begin(), valid.end(), [](auto v) { return v != 0; });
}

double SegmentedScan::typicalSigma_m(const RangeNoise& noise) const
{
  const int returns = noise.grows() ? validRays() : 0;
  if (returns == 0) return noise.sigma_m;
  double sum_m2 = 0;
  for (int ray = 0; ray < rays(); ++ray)
    if (isValid(ray)) sum_m2 += noise.varianceAt_m2(range_m[static_cast<std::size_t>(ray)]);
  return std::sqrt(sum_m2 / returns);
}

double SegmentedScan::denoisedRange_m(int ray) const
{
  const Segment* segment = segmentAt(ray);
  return segment ? segment->line.rangeAt_m(grid.bearing_rad(ray))
                 : range_m[static_cast<std::size_t>(ray)];
}
}  // namespace psmks
