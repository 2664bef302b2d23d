/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/CollinearityStatistic.h>
#include <psmks/segmentation/NoiseEstimate.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace psmks
{
namespace
{
constexpr double kLargest_m = 0.08;          // beyond, it is clutter and not noise
constexpr double kLargestPerMetre_m = 0.03;  // the same

/** Between near and far; 0 where there are no ranges. */
double meanRange_m(const RaySoA& rays)
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
double medianRange_m(const RaySoA& rays, const RangeSpan& span, std::vector<double>& scratch)
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
std::optional<RangeNoise> grownNoise(const RaySoA& rays, double least_m,
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

RangeNoise shownNoise(const RaySoA& rays, std::vector<double>& scratch)
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
