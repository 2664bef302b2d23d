/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/RaySoA.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** Copies values into a column that begins with element `first`, goes on with element 0 after the
 * last, and ends in a block of zeros. */
void copyFrom(const double* source, int count, int first, std::vector<double>& column)
{
  column.resize(static_cast<std::size_t>(count) + RaySoA::kBlock);
  const auto rest = std::copy(source + first, source + count, column.begin());
  std::fill(std::copy(source, source + first, rest), column.end(), 0.0);
}
}  // namespace

void RaySoA::load(const SegmentedScan& scan)
{
  rays = scan.rays();
  noise = scan.rangeNoise;
  startAt(scan, 0);
}

void RaySoA::startAt(const SegmentedScan& scan, int ray)
{
  start = ray;
  copyFrom(scan.grid.cosines(), rays, ray, cosine);
  copyFrom(scan.grid.sines(), rays, ray, sine);
  copyFrom(scan.range_m.data(), rays, ray, range_m);
  inverseRange_1_m.resize(range_m.size());
  for (std::size_t p = 0; p < range_m.size(); ++p)
    inverseRange_1_m[p] = range_m[p] > 0 ? 1 / range_m[p] : 0;
  mark.assign(range_m.size(), SegmentedScan::kNoSegment);
}

void RaySoA::computeMoments()
{
  moments.resize(range_m.size());
  for (std::size_t p = 0; p < moments.size(); ++p)
    moments[p] = LineInformation::moments(cosine[p], sine[p], range_m[p]);
  if (!noise.grows()) return;
  for (std::size_t p = 0; p < moments.size(); ++p) moments[p] *= noise.weightAt(range_m[p]);
}
}  // namespace psmks
