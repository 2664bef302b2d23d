/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace psmks
{
namespace
{
/** Smallest range that is valid. Definition: below what any scanner measures, and large enough that
 * its inverse to the fourth power does not overflow. */
constexpr double kNearest_m = 1e-4;

/** Range from which on none is valid. Definition: above what any scanner measures, and small enough
 * that its fourth power does not overflow. */
constexpr double kFarthest_m = 1e6;

/** Range from which on a reading is no return. */
double upperLimit_m(const Scan& scan, const PreprocessingOptions& options)
{
  double limit_m = kFarthest_m;
  if (scan.maxRange_m > 0) limit_m = std::min(limit_m, scan.maxRange_m);
  if (options.maxRange_m > 0) limit_m = std::min(limit_m, options.maxRange_m);
  return limit_m;
}

/** Makes the rays invalid that the scan flags as invalid. */
void dropFlagged(const std::vector<std::uint8_t>& valid, SegmentedScan& result)
{
  for (std::size_t i = 0; i < valid.size(); ++i)
  {
    if (valid[i]) continue;
    result.valid[i] = 0;
    result.range_m[i] = 0;
  }
}

/** The largest k such that only every k-th ray returns; 1 where there are too few returns to tell.
 */
int commonSpacing(const SegmentedScan& scan)
{
  /** Fewest returns that tell it. Unit: returns. Evidence: all of eight rays that return at random
   * are a multiple of two apart once in 128 times. */
  constexpr int kFewest = 8;
  int spacing = 0, before = -1, returns = 0;
  for (int ray = 0; ray < scan.rays() && spacing != 1; ++ray)
  {
    if (!scan.isValid(ray)) continue;
    if (before >= 0) spacing = std::gcd(spacing, ray - before);
    before = ray;
    ++returns;
  }
  return returns < kFewest ? 1 : spacing;
}

/** Takes the rays out that never return, where these are all but every k-th: the scanner is then
 * one with k times the increment. */
void dropSilentRays(SegmentedScan& scan)
{
  const int spacing = commonSpacing(scan);
  if (spacing < 2 || (scan.grid.closed() && scan.rays() % spacing != 0)) return;
  const auto firstReturn = std::find(scan.valid.begin(), scan.valid.end(), std::uint8_t{1});
  const int first = static_cast<int>(firstReturn - scan.valid.begin()) % spacing;
  const int count = (scan.rays() - 1 - first) / spacing + 1;
  const double increment_rad = spacing * scan.grid.increment_rad();
  if (!BeamGrid::accepts(scan.grid.bearing_rad(first), increment_rad, count)) return;
  for (int kept = 0; kept < count; ++kept)
  {
    const auto from = static_cast<std::size_t>(first + kept * spacing);
    scan.range_m[static_cast<std::size_t>(kept)] = scan.range_m[from];
    scan.valid[static_cast<std::size_t>(kept)] = scan.valid[from];
  }
  scan.range_m.resize(static_cast<std::size_t>(count));
  scan.valid.resize(static_cast<std::size_t>(count));
  scan.segmentOfRay.resize(static_cast<std::size_t>(count));
  scan.grid = BeamGrid(scan.grid.bearing_rad(first), increment_rad, count);
}
}  // namespace

void cleanScan(const Scan& scan, const PreprocessingOptions& options, SegmentedScan& result)
{
  const auto rays = static_cast<std::size_t>(scan.grid.count());
  result.grid = scan.grid;
  result.maxRange_m = upperLimit_m(scan, options);
  result.stamp_s = scan.stamp_s;
  result.rangeNoise = {};
  result.returnSpacing = 1;
  result.segments.clear();
  result.range_m.assign(rays, 0.0);
  result.valid.assign(rays, 0);
  result.segmentOfRay.assign(rays, SegmentedScan::kNoSegment);
  if (scan.range_m.size() != rays) return;

  const double lower_m = std::max(kNearest_m, options.minRange_m);
  const double upper_m = result.maxRange_m;
  const double* read_m = scan.range_m.data();
  double* range_m = result.range_m.data();
  std::uint8_t* valid = result.valid.data();
  for (std::size_t i = 0; i < rays; ++i)
  {
    const bool within = (read_m[i] > lower_m) & (read_m[i] < upper_m);  // false for NaN
    valid[i] = within;
    range_m[i] = within ? read_m[i] : 0;
  }
  if (scan.valid.size() == rays) dropFlagged(scan.valid, result);
  dropSilentRays(result);
}

bool hasReturns(const Scan& scan)
{
  SegmentedScan cleaned;
  cleanScan(scan, PreprocessingOptions(), cleaned);
  return cleaned.hasValidRay();
}

void medianFilter(int window, std::vector<double>& scratch, SegmentedScan& scan)
{
  const int half = window / 2;
  if (half < 1) return;
  const auto rays = static_cast<std::size_t>(scan.rays());
  scratch.resize(rays + static_cast<std::size_t>(2 * half + 1));
  std::copy(scan.range_m.begin(), scan.range_m.end(), scratch.begin());
  const auto windowBegin = scratch.begin() + static_cast<std::ptrdiff_t>(rays);
  for (int i = 0; i < scan.rays(); ++i)
  {
    if (!scan.isValid(i)) continue;
    auto windowEnd = windowBegin;
    for (int step = -half; step <= half; ++step)
    {
      const int j = scan.grid.neighbour(i, step);
      if (j >= 0 && scan.isValid(j)) *windowEnd++ = scratch[static_cast<std::size_t>(j)];
    }
    const auto middle = windowBegin + (windowEnd - windowBegin) / 2;
    std::nth_element(windowBegin, middle, windowEnd);
    scan.range_m[static_cast<std::size_t>(i)] = *middle;
  }
}
}  // namespace psmks
