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
/** Largest standard deviation of a short range that is believed; what looks noisier is clutter.
 * Evidence: measured. */
constexpr double kLargest_m = 0.08;

/** Largest growth of the standard deviation per metre of range that is believed; what seems to grow
 * faster is clutter. Evidence: measured. */
constexpr double kLargestPerMetre_m = 0.03;

/** The far half of the rays has to be so many times as noisy as the near half before noise is said
 * to grow with the range. Unit: ratio. Evidence: measured. */
constexpr double kClearGrowth = 2;

/** Where noise grows, the standard deviation of a short range is at least so many times the stated
 * one: a scan that is noisy far away is not quiet near by. Unit: ratio. Evidence: measured. */
constexpr double kLeastRise = 1.3;

/** Growth is looked for where the rays show so many times the stated noise. Unit: ratio. Evidence:
 * measured. */
constexpr double kSomewhatMore = 1.2;

/** The stated noise is given up where the rays show so many times as much. Unit: ratio. Evidence:
 * measured. */
constexpr double kClearlyMore = 1.6;

/** Mean valid range, which separates near rays from far ones; 0 where there are no ranges. */
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

/** Median of the valid ranges within a span; 0 where there are none. */
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

/** Noise that grows with the range, from the variances of the near and of the far rays: the line
 * sigma(r)^2 = sigma^2 + slope^2 r^2 through both at their median ranges.
 *  @param least_m the far rays have to be noisier than this
 *  @return nothing where the far rays are not noisier than that and clearly noisier than the near
 * ones */
std::optional<RangeNoise> grownNoise(const RaySoA& rays, double least_m,
                                     std::vector<double>& scratch)
{
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
