/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/segmentation/RangeRounding.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace psmks
{
namespace
{
/** Ranges that differ by less are equal. Definition: above the rounding of ranges that were stored
 * as floats, below any step of a scanner. */
constexpr double kSame_m = 1e-5;

/** Smallest rounding step that counts, as a multiple of the stated standard deviation. Unit:
 * standard deviations. Evidence: rounding to this step adds 1.75^2 / 12, a quarter, to the
 * variance and an eighth to the standard deviation; less is no matter. */
constexpr double kCoarse = 1.75;

/** Square of a rounding step over the variance of its error. Unit: ratio. Definition: a uniform
 * distribution of width 1 has the variance 1/12. */
constexpr double kStepSquaredOverVariance = 12;

/** How far the rays of a simulator that marches along a ray end behind the wall on average, as a
 * share of the step. Unit: share. Definition: the mean of a uniform distribution from 0 to 1. */
constexpr double kMeanOvershoot = 0.5;

/** Absolute difference of the ranges at a position and the next one; 0 where one has no range. */
double difference_m(const RaySoA& rays, int p)
{
  const auto at = static_cast<std::size_t>(p);
  if (!rays.valid(p) || !rays.valid(p + 1)) return 0;
  return std::abs(rays.range_m[at + 1] - rays.range_m[at]);
}

// ---- ranges that are multiples exactly ----------------------------------------------------------

/** Smallest difference between neighbouring ranges that are not equal.
 *  @return metres; 0 where a difference is below `least_m`, which ranges without a coarse step show
 * after a few rays */
double smallestDifference_m(const RaySoA& rays, double least_m)
{
  double smallest_m = std::numeric_limits<double>::infinity();
  for (int p = 0; p + 1 < rays.rays; ++p)
  {
    const double between_m = difference_m(rays, p);
    if (between_m < kSame_m) continue;
    if (between_m < least_m) return 0;
    smallest_m = std::min(smallest_m, between_m);
  }
  return std::isfinite(smallest_m) ? smallest_m : 0;
}

/** Whether all neighbouring ranges differ by multiples of a step, and many of them do differ. */
bool areMultiples(const RaySoA& rays, double step_m)
{
  /** Fewest different neighbours that prove a step. Unit: rays. Evidence: measured. */
  constexpr int kEnoughDifferences = 20;

  /** How far a difference may be from a multiple of the step. Unit: share of the step. Definition:
   * the rounding of stored floats against steps of centimetres. */
  constexpr double kRounding = 0.01;

  int different = 0;
  for (int p = 0; p + 1 < rays.rays; ++p)
  {
    const double steps = difference_m(rays, p) / step_m;
    if (std::abs(steps - std::round(steps)) > kRounding) return false;
    different += steps > kRounding;
  }
  return different >= kEnoughDifferences;
}

// ---- multiples beneath noise --------------------------------------------------------------------

// Differences of neighbouring ranges are counted in bins and correlated with cosine waves. Where
// the differences are multiples of a wave's length, all of them lie on its crests. Differences
// below half of a wave's length do not count for it: they are noise, and walls that are not stepped
// at all.

/** Number of bins of range differences. Unit: bins. Definition: with kBin_m they reach from
 * kFirst_m to 43 cm, two periods of the longest wave. */
constexpr int kBins = 40;

/** Number of waves. Unit: waves. Definition: with kSpacing_1_m their lengths reach from 20 cm down
 * to 6 cm; shorter ones do not show in bins of 1 cm. */
constexpr int kWaves = 20;

/** Width of a bin. Evidence: a sixth of the shortest wave. */
constexpr double kBin_m = 0.01;

/** Smallest difference that is counted. Evidence: half of the shortest wave; smaller ones count
 * for no wave. */
constexpr double kFirst_m = 0.03;

/** Length of the longest wave. Evidence: above 0.8 cells of 20 cm, the coarsest usual grid map.
 */
constexpr double kLongest_m = 0.2;

/** Difference of the frequencies of two neighbouring waves. Evidence: a quarter of a period over
 * all bins, so that no step falls between two waves. */
constexpr double kSpacing_1_m = 0.6;

/** Fewest differences that prove a step. Unit: rays. Evidence: measured. */
constexpr float kEnoughOnWaves = 30;

/** Mean height of the wave at the differences above which the wave's length is the step. Unit: mean
 * cosine. Evidence: rays marched through a grid map reach 0.79 to 0.90 in all of 1,733 scans, real
 * scans at most 0.45. */
constexpr float kClear = 0.55F;

using Bins = Eigen::Array<float, kBins, 1>;

/** The waves at the middles of the bins: a row per wave, a column per bin. */
struct Waves
{
  using PerBin = Eigen::Array<float, kWaves, kBins>;
  using Sums = Eigen::Array<float, kWaves, 1>;

  Waves()
  {
    for (int w = 0; w < kWaves; ++w)
      for (int b = 0; b < kBins; ++b)
      {
        const double middle_m = kFirst_m + kBin_m * (b + 0.5);
        counts(w, b) = 2 * middle_m >= length_m(w);
        height(w, b) =
            counts(w, b) * static_cast<float>(std::cos(2 * kPi * middle_m / length_m(w)));
      }
  }

  static double length_m(int wave) { return 1 / (1 / kLongest_m + kSpacing_1_m * wave); }

  PerBin counts;  //!< 1 for the bins that count for a wave, else 0
  PerBin height;  //!< height of the wave in the middle of the bins that count for it, else 0
};

/** Counts the differences of neighbouring ranges by size. Differences outside the bins are left
 * out; those to a ray without a range, which reads 0, usually are. */
Bins countDifferences(const RaySoA& rays)
{
  /** Most rays that are looked at. Unit: rays. Definition: capacity of an array; the scans of finer
   * scanners show their step in so many rays, too. */
  constexpr int kPlenty = 1000;

  std::array<std::uint8_t, kPlenty> bins;
  std::size_t counted = 0;
  const double* range_m = rays.range_m.data();
  const int differences = std::min(rays.rays - 1, kPlenty);
  for (int p = 0; p < differences; ++p)
  {
    const double beyond_m = std::abs(range_m[p + 1] - range_m[p]) - kFirst_m;
    const int bin = static_cast<int>(beyond_m * (1 / kBin_m) + 1) - 1;  // rounds down from -1 on
    bins[counted] = static_cast<std::uint8_t>(bin);
    counted += static_cast<unsigned>(bin) < kBins;
  }
  Bins counts = Bins::Zero();
  for (std::size_t d = 0; d < counted; ++d) ++counts[bins[d]];
  return counts;
}

/** Length of the wave on whose crests the range differences lie; 0 where they lie on none. */
double stepBeneathNoise_m(const RaySoA& rays)
{
  static const Waves waves;
  const Bins counts = countDifferences(rays);
  if (counts.sum() < kEnoughOnWaves) return 0;
  Waves::Sums differences = Waves::Sums::Zero(), heights = Waves::Sums::Zero();
  for (int b = 0; b < kBins; ++b)
  {
    differences += counts[b] * waves.counts.col(b);
    heights += counts[b] * waves.height.col(b);
  }
  int wave = 0;
  const float highest = (heights / differences.max(kEnoughOnWaves)).maxCoeff(&wave);
  return highest > kClear ? Waves::length_m(wave) : 0;
}
}  // namespace

RangeNoise RangeRounding::addedTo(RangeNoise noise) const
{
  noise.sigma_m = std::hypot(noise.sigma_m, step_m / std::sqrt(kStepSquaredOverVariance));
  return noise;
}

RangeRounding findRounding(const RaySoA& rays)
{
  const double least_m = kCoarse * rays.noise.sigma_m;
  const double smallest_m = smallestDifference_m(rays, least_m);
  if (smallest_m > 0 && areMultiples(rays, smallest_m)) return {smallest_m, 0};
  const double step_m = stepBeneathNoise_m(rays);
  if (!(step_m > least_m)) return {};
  return {step_m, kMeanOvershoot * step_m};
}
}  // namespace psmks
