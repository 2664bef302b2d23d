/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/NoiseEstimate.h>
#include <psmks/core/ThreeRayTest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace psmks
{
namespace
{
constexpr double kLargest_m = 0.08;          // beyond, it is clutter and not noise
constexpr double kLargestPerMetre_m = 0.03;  // the same

/** Of two neighbouring positions, the first being p; 0 where one has no range. */
double step_m(const RayColumns& rays, int p)
{
  if (!rays.valid(p) || !rays.valid(p + 1)) return 0;
  return std::abs(rays.range_m[static_cast<std::size_t>(p) + 1] -
                  rays.range_m[static_cast<std::size_t>(p)]);
}

constexpr double kSame_m = 1e-5;  // ranges that differ by less differ by their storage

/** The smallest difference between neighbouring ranges; 0 where one is below `least_m`, which is
 * so after a few rays where ranges are fine. */
double smallestStep_m(const RayColumns& rays, double least_m)
{
  double smallest_m = std::numeric_limits<double>::infinity();
  for (int p = 0; p + 1 < rays.rays; ++p)
  {
    const double between_m = step_m(rays, p);
    if (between_m < kSame_m) continue;
    if (between_m < least_m) return 0;
    smallest_m = std::min(smallest_m, between_m);
  }
  return std::isfinite(smallest_m) ? smallest_m : 0;
}

/** Whether neighbouring ranges differ by multiples of a step, many of them. */
bool areMultiples(const RayColumns& rays, double quantum_m)
{
  constexpr int kEnough = 20;
  constexpr double kRounding = 0.01;  // of the quantum
  int steps = 0;
  for (int p = 0; p + 1 < rays.rays; ++p)
  {
    const double quanta = step_m(rays, p) / quantum_m;
    if (std::abs(quanta - std::round(quanta)) > kRounding) return false;
    steps += quanta > kRounding;
  }
  return steps >= kEnough;
}

/** Between near and far; 0 where there are no ranges. */
double meanRange_m(const RayColumns& rays)
{
  double sum_m = 0;
  int returns = 0;
  for (int p = 0; p < rays.rays; ++p)
  {
    sum_m += rays.range_m[static_cast<std::size_t>(p)];  // 0 where there is none
    returns += rays.valid(p);
  }
  return returns > 0 ? sum_m / returns : 0;
}

/** Of the ranges of a span; 0 where there are none. */
double medianRange_m(const RayColumns& rays, const RangeSpan& span, std::vector<double>& scratch)
{
  scratch.clear();
  for (int p = 0; p < rays.rays; ++p)
    if (const double range_m = rays.range_m[static_cast<std::size_t>(p)];
        range_m > 0 && span.holds(range_m))
      scratch.push_back(range_m);
  if (scratch.empty()) return 0;
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return *middle;
}

/** The variances of the near and of the far rays give var(r) = sigma^2 + slope^2 r^2.
 *  @return none where the far rays are not clearly noisier than the near ones, and than `least_m`
 */
std::optional<RangeNoise> grownNoise(const RayColumns& rays, double least_m,
                                     std::vector<double>& scratch)
{
  constexpr double kClearGrowth = 2;
  constexpr double kLeastRise = 1.3;  // a scan that is noisy far away is not quiet near by
  RangeSpan near, far;
  near.to_m = far.from_m = meanRange_m(rays);
  const double far_m = estimateRangeSigma_m(rays, scratch, far);
  if (!(far_m > least_m)) return std::nullopt;
  const double near_m = estimateRangeSigma_m(rays, scratch, near);
  if (!(near_m > 0) || !(far_m > kClearGrowth * near_m)) return std::nullopt;
  const double nearRange_m = medianRange_m(rays, near, scratch);
  const double farRange_m = medianRange_m(rays, far, scratch);
  const double slope2 =
      (far_m * far_m - near_m * near_m) / (farRange_m * farRange_m - nearRange_m * nearRange_m);
  const double rest_m2 = near_m * near_m - slope2 * nearRange_m * nearRange_m;
  const double nearest_m = kLeastRise * rays.noise.sigma_m;
  return RangeNoise{std::sqrt(std::max(rest_m2, nearest_m * nearest_m)),
                    std::min(std::sqrt(slope2), kLargestPerMetre_m)};
}
}  // namespace

RangeNoise noiseWithRounding(const RayColumns& rays)
{
  constexpr double kCoarse = 1.75;  // of sigma: rounding then adds an eighth of it or more
  RangeNoise noise = rays.noise;
  const double quantum_m = smallestStep_m(rays, kCoarse * noise.sigma_m);
  if (quantum_m > 0 && areMultiples(rays, quantum_m))
    noise.sigma_m = std::hypot(noise.sigma_m, quantum_m / std::sqrt(12.0));
  return noise;
}

RangeNoise shownNoise(const RayColumns& rays, std::vector<double>& scratch)
{
  constexpr double kSomewhatMore = 1.2, kClearlyMore = 1.6;
  const RangeNoise& stated = rays.noise;
  const double clear_m = kClearlyMore * stated.sigma_m;
  if (!mayShowNoiseAbove(rays, clear_m)) return stated;
  const double shown_m = estimateRangeSigma_m(rays, scratch);
  if (!stated.grows() && shown_m > kSomewhatMore * stated.sigma_m)
    if (const auto grown = grownNoise(rays, clear_m, scratch)) return *grown;
  if (!(shown_m > clear_m)) return stated;
  return stated.scaledTo(std::min(shown_m, std::max(stated.sigma_m, kLargest_m)));
}
}  // namespace psmks
