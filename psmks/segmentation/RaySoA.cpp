/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/RaySoA.h>

#include <algorithm>
#include <numeric>

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
  noise = scan.rangeNoise;
  startAt(scan, 0);
}

void RaySoA::startAt(const SegmentedScan& scan, int ray)
{
  rays = scan.rays();
  copyFrom(scan.grid.cosines(), rays, ray, cosine);
  copyFrom(scan.grid.sines(), rays, ray, sine);
  copyFrom(scan.range_m.data(), rays, ray, range_m);
  inverseRange_1_m.resize(range_m.size());
  for (std::size_t p = 0; p < range_m.size(); ++p)
    inverseRange_1_m[p] = range_m[p] > 0 ? 1 / range_m[p] : 0;
  mark.assign(range_m.size(), SegmentedScan::kNoSegment);
  rayOf.resize(static_cast<std::size_t>(rays));
  std::iota(rayOf.begin(), rayOf.end() - ray, ray);
  std::iota(rayOf.end() - ray, rayOf.end(), 0);
}

void RaySoA::closeHoles(int longest)
{
  std::size_t kept = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(rays);)
  {
    std::size_t end = p;
    while (end < static_cast<std::size_t>(rays) && !(range_m[end] > 0)) ++end;
    const std::size_t hole = end - p;
    const std::size_t left =
        hole > static_cast<std::size_t>(longest) ? std::min<std::size_t>(hole, kBlock) : 0;
    for (std::size_t i = 0; i < left; ++i) move(p + i, kept++);
    if (end < static_cast<std::size_t>(rays)) move(end, kept++);
    p = end + 1;
  }
  endAt(kept);
}

void RaySoA::move(std::size_t from, std::size_t to)
{
  cosine[to] = cosine[from], sine[to] = sine[from];
  range_m[to] = range_m[from], inverseRange_1_m[to] = inverseRange_1_m[from];
  rayOf[to] = rayOf[from];
}

/** Drops the positions from one on, and puts a block of invalid rays there. */
void RaySoA::endAt(std::size_t position)
{
  rays = static_cast<int>(position);
  for (std::vector<double>* column : {&cosine, &sine, &range_m, &inverseRange_1_m})
  {
    column->resize(position + kBlock);
    std::fill(column->begin() + static_cast<std::ptrdiff_t>(position), column->end(), 0.0);
  }
  mark.resize(position + kBlock);
  rayOf.resize(position);
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
