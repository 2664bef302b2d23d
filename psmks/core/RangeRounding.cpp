/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Angle.h>
#include <psmks/core/RangeRounding.h>

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
double difference_m(const RayColumns& rays, int p)
{
  const auto at = static_cast<std::size_t>(p);
  if (!rays.valid(p) || !rays.valid(p + 1)) return 0;
  return std::abs(rays.range_m[at + 1] - rays.range_m[at]);
}

// ---- ranges that are multiples exactly ----------------------------------------------------------

/** The smallest difference between neighbouring ranges; 0 where one is below `least_m`, which is
 * so after a few rays where ranges are fine. */
double smallestDifference_m(const RayColumns& rays, double least_m)
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
bool areMultiples(const RayColumns& rays, double step_m)
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

struct Wave
{
  explicit Wave(double frequency_1_m) : length_m(1 / frequency_1_m)
  {
    for (int b = 0; b < kBins; ++b)
    {
      const double middle_m = kFirst_m + kBin_m * (b + 0.5);
      counts[b] = 2 * middle_m >= length_m;
      height[b] = counts[b] * static_cast<float>(std::cos(2 * kPi * frequency_1_m * middle_m));
    }
  }

  double length_m;
  Bins counts;  //!< 1 for the bins that count, else 0
  Bins height;  //!< in the middle of these bins, else 0
};

const std::vector<Wave>& waves()
{
  static const std::vector<Wave> all = []
  {
    std::vector<Wave> result;
    for (int w = 0; w < kWaves; ++w) result.emplace_back(1 / kLongest_m + kSpacing_1_m * w);
    return result;
  }();
  return all;
}

/** Differences of neighbouring ranges by size; what is smaller or larger is left out. */
Bins countDifferences(const RayColumns& rays)
{
  constexpr std::size_t kPlenty = 500;
  std::array<std::uint8_t, kPlenty> bins;
  std::size_t differences = 0;
  const double* range_m = rays.range_m.data();
  for (int p = 0; p + 1 < rays.rays && differences < kPlenty; ++p)
  {
    const double here_m = range_m[p], next_m = range_m[p + 1];
    const int bin = static_cast<int>((std::abs(next_m - here_m) - kFirst_m) * (1 / kBin_m) + 1) - 1;
    bins[differences] = static_cast<std::uint8_t>(bin);
    differences += (here_m > 0) & (next_m > 0) & (static_cast<unsigned>(bin) < kBins);
  }
  Bins counts = Bins::Zero();
  for (std::size_t d = 0; d < differences; ++d) ++counts[bins[d]];
  return counts;
}

/** The length of the wave on whose crests the differences stand, or 0. */
double stepBeneathNoise_m(const RayColumns& rays)
{
  constexpr float kEnough = 30, kClear = 0.55F;  // real scans reach 0.45
  const Bins counts = countDifferences(rays);
  if (counts.sum() < kEnough) return 0;
  double step_m = 0;
  float highest = kClear;
  for (const Wave& wave : waves())
  {
    const float differences = (counts * wave.counts).sum();
    const float height = (counts * wave.height).sum();
    if (differences < kEnough || height <= highest * differences) continue;
    highest = height / differences;
    step_m = wave.length_m;
  }
  return step_m;
}
}  // namespace

RangeNoise RangeRounding::addedTo(RangeNoise noise) const
{
  noise.sigma_m = std::hypot(noise.sigma_m, step_m / std::sqrt(12.0));
  return noise;
}

RangeRounding findRounding(const RayColumns& rays)
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
