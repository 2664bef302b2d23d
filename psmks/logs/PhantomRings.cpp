/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/PhantomRings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace psmks
{
namespace
{
/** Width of a bin. Definition: the unit of coarse scanners. */
constexpr double kRingBin_m = 0.01;

/** Range from which on readings are not looked at. Definition: farther than 2D scanners see. */
constexpr double kFarthestReading_m = 200;

/** Widths of bands that are tried, in bins. Unit: bins. Definition: from one value to values that
 * are scattered over a metre. */
constexpr std::array<std::size_t, 7> kRingWidths{1, 2, 5, 10, 20, 50, 100};
}  // namespace

void PhantomRings::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
  if (centimetres_.empty())
    centimetres_.resize(static_cast<std::size_t>(kFarthestReading_m / kRingBin_m) + 1);
  ++scans_;
  bearings_rad_ += scan.aperture;
  for (std::size_t ray = 0; ray < scan.getScanSize(); ++ray)
  {
    const double range_m = scan.getScanRange(ray);
    const bool isReading = scan.getScanRangeValidity(ray) && range_m > 0 &&
                           range_m < kFarthestReading_m &&
                           (scan.maxRange <= 0 || range_m < scan.maxRange);
    if (!isReading) continue;
    ++centimetres_[static_cast<std::size_t>(range_m / kRingBin_m)];
    ++readings_;
  }
}

double PhantomRings::countBetween(std::size_t first, std::size_t last) const
{
  const auto begin = centimetres_.begin();
  const auto size = centimetres_.size();
  return std::accumulate(begin + static_cast<std::ptrdiff_t>(std::min(first, size)),
                         begin + static_cast<std::ptrdiff_t>(std::min(last, size)), 0.0);
}

/** Whether so many bins from the first on stand out from those beside them, and from what a flat
 * wall can show. The bins next to them are left out, for values that lie at an edge. */
bool PhantomRings::standsOut(std::size_t first, std::size_t width) const
{
  /** Share of the readings that are no chance. Unit: share. Definition: two rays of a scan of 361.
   */
  constexpr double kShare = 0.005;

  /** How many times the readings of other bands. Unit: ratio. Definition: a wall has three times.
   */
  constexpr double kTimes = 10;

  /** How many times the bearings of a flat wall. Unit: ratio. Definition: a wall to either side. */
  constexpr double kWalls = 2;
  /** Widest band, beside its range. Unit: share. Definition: the walls of a room are about as far
   * as each other to a tenth or more. */
  constexpr double kWidest = 0.05;
  const double count = countBetween(first, first + width);
  const bool isNarrow =
      width == 1 || static_cast<double>(width) <= kWidest * static_cast<double>(first);
  if (!isNarrow || count < kShare * readings_) return false;
  for (std::size_t apart = 2; apart <= 4; ++apart)
  {
    const std::size_t above = first + apart * width;
    const double beside = std::max(
        countBetween(above, above + width),
        first >= apart * width ? countBetween(first - apart * width, first - (apart - 1) * width)
                               : 0.0);
    if (count < kTimes * beside) return false;
  }
  const double range_m = kRingBin_m * (static_cast<double>(first) + 0.5);
  const double width_m = kRingBin_m * static_cast<double>(width);
  const double ofAWall_rad = 2 * std::sqrt(2 * width_m / range_m);
  const double perReading_rad = bearings_rad_ / std::max(readings_, 1.0);
  return count * perReading_rad > kWalls * ofAWall_rad * scans_;
}

/** Whether no reading is left, but for noise beside the bands: then nothing tells rings from a
 * world.
 *  @param isTaken of each bin, whether a band holds it */
bool PhantomRings::holdsAll(const std::vector<bool>& isTaken) const
{
  /** Share of the readings that is noise. Definition: a ray in a hundred. */
  constexpr double kNoise = 0.01;

  /** Bins beside a band that belong to it. Definition: two units of coarse scanners. */
  constexpr std::size_t kBeside = 2;
  double left = 0;
  for (std::size_t bin = 0; bin < isTaken.size(); ++bin)
  {
    const auto begin = isTaken.begin() + static_cast<std::ptrdiff_t>(bin - std::min(bin, kBeside));
    const auto end =
        isTaken.begin() + static_cast<std::ptrdiff_t>(std::min(bin + kBeside + 1, isTaken.size()));
    if (std::find(begin, end, true) == end) left += centimetres_[bin];
  }
  return left < kNoise * readings_;
}

std::vector<RangeBand> PhantomRings::bands() const
{
  /** Fewest scans that tell rings from walls. Unit: scans. Definition: two seconds, in which a
   * robot moves. */
  constexpr int kFewestScans = 20;
  std::vector<RangeBand> bands;
  if (scans_ < kFewestScans) return bands;
  std::vector<bool> isTaken(centimetres_.size(), false);
  for (const std::size_t width : kRingWidths)
    for (std::size_t first = 0; first + width <= centimetres_.size(); first += (width + 1) / 2)
    {
      const auto begin = isTaken.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = begin + static_cast<std::ptrdiff_t>(width);
      if (std::find(begin, end, true) != end || !standsOut(first, width)) continue;
      const double bin_m = kRingBin_m, from = static_cast<double>(first);
      std::fill(begin, end, true);
      bands.push_back({bin_m * from, bin_m * (from + static_cast<double>(width)),
                       static_cast<int>(countBetween(first, first + width))});
    }
  if (holdsAll(isTaken)) return {};
  std::sort(bands.begin(), bands.end(),
            [](const RangeBand& a, const RangeBand& b) { return a.from_m < b.from_m; });
  return bands;
}
}  // namespace psmks
