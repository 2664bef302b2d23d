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
constexpr double kSame_m = 1e-5;  // ranges that differ by less differ by their storage

/** Between two neighbouring positions, the first being p; 0 where one has no range. */
double difference_m(const RaySoA& rays, int p)
{
  const auto at = static_cast<std::size_t>(p);
  if (!rays.valid(p) || !rays.valid(p + 1)) return 0;
  return std::abs(rays.range_m[at + 1] - rays.range_m[at]);
}

// ---- ranges that are multiples exactly ----------------------------------------------------------

/** The smallest difference between neighbouring ranges; 0 where one is below `least_m`, which is
 * so after a few rays where ranges are fine. */
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

/** Whether neighbouring ranges differ by multiples of a step, many of them. */
bool areMultiples(const RaySoA& rays, double step_m)
{
  constexpr int kEnough = 20;
  constexpr double kRounding = 0.01;  // of the step
  int different = 0;
  for (int p = 0; p + 1 < rays.rays; ++p)
  {
    const double steps = difference_m(rays, p) / step_m;
    if (std::abs(steps - std::round(steps)) > kRounding) return false;
    different += steps > kRounding;
  }
  return different >= kEnough;
}

// ---- multiples beneath noise --------------------------------------------------------------------

/* Differences of neighbouring ranges, counted in bins of 1 cm, are held against waves: where they
 * are multiples of a wave's length, all stand on its crests. Those below half of the length are
 * left out: they are noise, and walls that are not stepped at all. */
constexpr int kBins = 40, kWaves = 20;
constexpr double kBin_m = 0.01, kFirst_m = 0.03;
constexpr double kLongest_m = 0.2;    // of the waves
constexpr double kSpacing_1_m = 0.6;  // of their frequencies: a quarter of a period over all bins

using Bins = Eigen::Array<float, kBins, 1>;

/** A row for each wave. */
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

  PerBin counts;  //!< 1 for the bins that count, else 0
  PerBin height;  //!< of the wave in the middle of these bins, else 0
};

/** Differences of neighbouring ranges by size; what is smaller or larger is left out, as beside
 * rays without a range, which read 0. */
Bins countDifferences(const RaySoA& rays)
{
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

/** The length of the wave on whose crests the differences stand, or 0. */
double stepBeneathNoise_m(const RaySoA& rays)
{
  static const Waves waves;
  constexpr float kEnough = 30, kClear = 0.55F;  // real scans reach 0.45
  const Bins counts = countDifferences(rays);
  if (counts.sum() < kEnough) return 0;
  Waves::Sums differences = Waves::Sums::Zero(), heights = Waves::Sums::Zero();
  for (int b = 0; b < kBins; ++b)
  {
    differences += counts[b] * waves.counts.col(b);
    heights += counts[b] * waves.height.col(b);
  }
  int wave = 0;
  const float highest = (heights / differences.max(kEnough)).maxCoeff(&wave);
  return highest > kClear ? Waves::length_m(wave) : 0;
}
}  // namespace

RangeNoise RangeRounding::addedTo(RangeNoise noise) const
{
  noise.sigma_m = std::hypot(noise.sigma_m, step_m / std::sqrt(12.0));
  return noise;
}

RangeRounding findRounding(const RaySoA& rays)
{
  constexpr double kCoarse = 1.75;  // of sigma: rounding then adds an eighth of it or more
  const double least_m = kCoarse * rays.noise.sigma_m;
  const double smallest_m = smallestDifference_m(rays, least_m);
  if (smallest_m > 0 && areMultiples(rays, smallest_m)) return {smallest_m, 0};
  const double step_m = stepBeneathNoise_m(rays);
  if (!(step_m > least_m)) return {};
  return {step_m, step_m / 2};
}
}  // namespace psmks
