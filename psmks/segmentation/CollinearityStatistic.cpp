/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/CollinearityStatistic.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Fewest statistics from which a standard deviation is estimated. Unit: statistics. Evidence:
 * measured. */
constexpr int kFewestStatistics = 20;

/** Largest statistic that counts as range noise; a larger one lies on a jump or a corner. Evidence:
 * measured. */
constexpr double kEdge_m = 0.2;

/** Median of the absolute value of a standard normal variable. Unit: standard deviations.
 * Definition: the 0.75 quantile of the standard normal distribution. */
constexpr double kMedianOfAbsoluteNormal = 0.6745;

/** A squared statistic as a fraction: the squared left side of the equation in
 * CollinearityStatistic.h over its variance for ranges with a standard deviation of 1 m. */
struct Fraction
{
  double square, variance;
};

/** Computes the statistic of three rays of a scan. */
class ThreeRays
{
 public:
  explicit ThreeRays(const RaySoA& rays)
      : inverse_(rays.inverseRange_1_m.data()),
        twoCosine_(2 * cosineOfIncrement(rays)),
        growth_1_m2_(rays.noise.growth_1_m2())
  {
  }

  /** @param a, b, c positions of a ray and its neighbours */
  Fraction at(int a, int b, int c) const
  {
    Fraction f = atEvenNoise(a, b, c);
    if (growth_1_m2_ > 0) f.variance += growth_1_m2_ * growing(a, b, c);
    return f;
  }

  /** The statistic as if all ranges were equally uncertain, which is enough to find a break.
   *  @param a, b, c positions of a ray and its neighbours */
  Fraction atEvenNoise(int a, int b, int c) const
  {
    // The variance of the inverse range of a ray is sigma^2 / r^4.
    const double x = inverse_[a], y = twoCosine_ * inverse_[b], z = inverse_[c];
    const double x2 = x * x, y2 = y * inverse_[b], z2 = z * z;
    const double sum = x - y + z;
    return {sum * sum, x2 * x2 + y2 * y2 + z2 * z2};
  }

  /** Whether the rays at all three positions have a range. */
  bool valid(int a, int b, int c) const
  {
    return (inverse_[a] > 0) & (inverse_[b] > 0) & (inverse_[c] > 0);
  }

 private:
  /** Variance of the left side per unit of RangeNoise::growth_1_m2(): a range variance of r^2 makes
   * the variance of the inverse range 1 / r^2. */
  double growing(int a, int b, int c) const
  {
    const double x = inverse_[a], y = twoCosine_ * inverse_[b], z = inverse_[c];
    return x * x + y * y + z * z;
  }

  static double cosineOfIncrement(const RaySoA& rays)
  {
    if (rays.rays < 2) return 1;
    return rays.cosine[0] * rays.cosine[1] + rays.sine[0] * rays.sine[1];
  }

  const double* inverse_;
  double twoCosine_, growth_1_m2_;
};
}  // namespace

void collinearityStatistics(const RaySoA& rays, std::vector<double>& statistics_m2,
                            const RangeSpan& span)
{
  const ThreeRays statistic(rays);
  statistics_m2.clear();
  for (int p = 1; p < rays.rays - 1; ++p)
  {
    const Fraction f = statistic.at(p - 1, p, p + 1);
    const bool counts =
        statistic.valid(p - 1, p, p + 1) && span.holds(rays.range_m[static_cast<std::size_t>(p)]);
    if (counts) statistics_m2.push_back(f.square / f.variance);
  }
}

double estimateRangeSigma_m(const RaySoA& rays, std::vector<double>& scratch, const RangeSpan& span)
{
  collinearityStatistics(rays, scratch, span);
  const auto isNoise = [](double statistic_m2) { return statistic_m2 <= kEdge_m * kEdge_m; };
  const auto end = std::partition(scratch.begin(), scratch.end(), isNoise);
  const auto statistics = end - scratch.begin();
  if (statistics < kFewestStatistics) return 0;
  const auto middle = scratch.begin() + statistics / 2;
  std::nth_element(scratch.begin(), middle, end);
  return std::sqrt(*middle) / kMedianOfAbsoluteNormal;
}

bool mayShowNoiseAbove(const RaySoA& rays, double sigma_m)
{
  /** Smallest distance of two statistics that are counted. Unit: rays. Definition: neighbouring
   * statistics share rays, statistics three rays apart do not. */
  constexpr int kSmallestStep = 3;

  /** How many statistics of a scan are counted, about. Unit: statistics. Evidence: measured. */
  constexpr int kCounted = 60;

  /** Share of the asked-for value that the counted median has to reach, because the median of so
   * few scatters. Unit: share. Evidence: measured. */
  constexpr double kMargin = 0.8;

  const double median_m = std::min(kEdge_m, kMargin * kMedianOfAbsoluteNormal * sigma_m);
  const int step = std::max(kSmallestStep, rays.rays / kCounted);
  const ThreeRays statistic(rays);
  int counted = 0, below = 0;
  for (int p = 1; p < rays.rays - 1; p += step)
  {
    const Fraction f = statistic.at(p - 1, p, p + 1);
    const bool counts =
        statistic.valid(p - 1, p, p + 1) & (f.square <= kEdge_m * kEdge_m * f.variance);
    counted += counts;
    below += counts & (f.square <= median_m * median_m * f.variance);
  }
  return 2 * below <= counted;
}

int strongestBreak(const RaySoA& rays)
{
  const ThreeRays statistic(rays);
  int strongest = 0;
  double largest_m2 = -1;
  for (int p = 0; p < rays.rays; ++p)
  {
    const int before = p > 0 ? p - 1 : rays.rays - 1, after = p + 1 < rays.rays ? p + 1 : 0;
    if (!rays.valid(p) || !rays.valid(after)) continue;
    if (!rays.valid(before)) return p;
    const Fraction f = statistic.atEvenNoise(before, p, after);
    if (f.square <= largest_m2 * f.variance) continue;
    largest_m2 = f.square / f.variance;
    strongest = p;
  }
  return strongest;
}
}  // namespace psmks
