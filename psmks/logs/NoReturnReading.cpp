/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/NoReturnReading.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kSickRange_m = 80, kSickLargestCode_m = 81.92;
constexpr double kBin_m = 0.05, kLastBin_m = 200;
constexpr double kNeighbourhood = 0.9;  // as a share of the largest reading
constexpr double kFewestTimes = 10;

std::size_t binOf(double range_m)
{
  return static_cast<std::size_t>(std::min(range_m, kLastBin_m) / kBin_m);
}
}  // namespace

NoReturnReading::NoReturnReading() : bins_(binOf(kLastBin_m) + 1) {}

void NoReturnReading::add(double range_m)
{
  if (!std::isfinite(range_m) || range_m <= 0) return;
  ++bins_[binOf(range_m)];
  if (range_m > largest_m_)
  {
    largest_m_ = range_m;
    timesLargest_ = 0;
  }
  if (range_m == largest_m_) ++timesLargest_;
}

double NoReturnReading::limit_m() const
{
  if (isCode()) return kSickRange_m;
  if (timesLargest_ >= kFewestTimes && timesLargest_ > readingsBelowLargest()) return largest_m_;
  return std::max(kSickRange_m, largest_m_ + 1);
}

bool NoReturnReading::isCode() const
{
  return largest_m_ >= kSickRange_m && largest_m_ <= kSickLargestCode_m;
}

double NoReturnReading::readingsBelowLargest() const
{
  double readings = -timesLargest_;
  for (std::size_t bin = binOf(kNeighbourhood * largest_m_); bin <= binOf(largest_m_); ++bin)
    readings += bins_[bin];
  return readings;
}
}  // namespace psmks
