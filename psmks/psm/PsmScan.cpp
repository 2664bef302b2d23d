/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmScan.h>
#include <psmks/psm/PsmSegmentation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** Range of a ray without a reading. Definition: farther than any reading. */
constexpr double kNoReading_m = std::numeric_limits<double>::infinity();

double maxRange_m(const Scan& scan, const PsmOptions& options)
{
  double limit_m = kNoReading_m;
  if (scan.maxRange_m > 0) limit_m = std::min(limit_m, scan.maxRange_m);
  if (options.maxRange_m > 0) limit_m = std::min(limit_m, options.maxRange_m);
  return limit_m;
}

/** The reading of each ray, or kNoReading_m. */
std::vector<double> readings(const Scan& scan, double limit_m)
{
  const auto rays = static_cast<std::size_t>(scan.grid.count());
  std::vector<double> range_m(rays, kNoReading_m);
  if (scan.range_m.size() != rays) return range_m;
  const bool flagged = scan.valid.size() == rays;
  for (std::size_t i = 0; i < rays; ++i)
  {
    const double r = scan.range_m[i];
    const bool usable = r > 0 && r < limit_m && (!flagged || scan.valid[i]);  // NaN is not usable
    if (usable) range_m[i] = r;
  }
  return range_m;
}

void medianFilter(const BeamGrid& grid, const std::vector<double>& raw_m, int window,
                  std::vector<double>& filtered_m)
{
  const int half = std::max(0, window / 2);
  const int last = grid.count() - 1;
  std::vector<double> inWindow(static_cast<std::size_t>(2 * half + 1));
  const auto middle = inWindow.begin() + half;
  for (int i = 0; i <= last; ++i)
  {
    for (int k = -half; k <= half; ++k)
    {
      const int j = grid.closed() ? grid.neighbour(i, k) : std::clamp(i + k, 0, last);
      inWindow[static_cast<std::size_t>(half + k)] = raw_m[static_cast<std::size_t>(j)];
    }
    std::nth_element(inWindow.begin(), middle, inWindow.end());
    filtered_m[static_cast<std::size_t>(i)] = *middle;
  }
}
}  // namespace

int PsmScan::goodRays() const
{
  return static_cast<int>(std::count(tag.begin(), tag.end(), PsmTag::Good));
}

void preparePsmScan(const Scan& scan, const PsmOptions& options, PsmScan& result)
{
  const auto rays = static_cast<std::size_t>(scan.grid.count());
  result.grid = scan.grid;
  result.maxRange_m = maxRange_m(scan, options);
  result.range_m.resize(rays);
  medianFilter(scan.grid, readings(scan, result.maxRange_m), options.medianWindow, result.range_m);

  result.tag.resize(rays);
  std::transform(result.range_m.begin(), result.range_m.end(), result.tag.begin(),
                 [](double r) { return std::isfinite(r) ? PsmTag::Good : PsmTag::BeyondRange; });
  segmentPsmScan(options.segmentBreak_m, result);
}
}  // namespace psmks
