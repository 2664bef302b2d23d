/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/CollinearityStatistic.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr int kFewestTests = 20;
constexpr double kEdge_m = 0.2;  // a test beyond it is a jump or a corner, not noise
constexpr double kMedianOfAbsoluteNormal = 0.6745;

/** One test as a fraction: squared left side over its variance for a range sigma of 1 m. */
struct Fraction
{
  double square, variance;
};

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

  /** The same as if all ranges were equally uncertain, which is enough to find a break. */
  Fraction atEvenNoise(int a, int b, int c) const
  {
    // var(1/r) = sigma^2 / r^4 for each ray
    const double x = inverse_[a], y = twoCosine_ * inverse_[b], z = inverse_[c];
    const double x2 = x * x, y2 = y * inverse_[b], z2 = z * z;
    const double sum = x - y + z;
    return {sum * sum, x2 * x2 + y2 * y2 + z2 * z2};
  }

  /** Whether all three have a range. */
  bool valid(int a, int b, int c) const
  {
    return (inverse_[a] > 0) & (inverse_[b] > 0) & (inverse_[c] > 0);
  }

 private:
  /** A variance that grows by r^2 is var(1/r) = 1 / r^2. */
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
  const ThreeRays test(rays);
  statistics_m2.clear();
  for (int p = 1; p < rays.rays - 1; ++p)
  {
    const Fraction f = test.at(p - 1, p, p + 1);
    const bool counts =
        test.valid(p - 1, p, p + 1) && span.holds(rays.range_m[static_cast<std::size_t>(p)]);
    if (counts) statistics_m2.push_back(f.square / f.variance);
  }
}

double estimateRangeSigma_m(const RaySoA& rays, std::vector<double>& scratch, const RangeSpan& span)
{
  collinearityStatistics(rays, scratch, span);
  const auto end = std::partition(scratch.begin(), scratch.end(),
                                  [](double test_m2) { return test_m2 <= kEdge_m * kEdge_m; });
  const auto tests = end - scratch.begin();
  if (tests < kFewestTests) return 0;
  const auto middle = scratch.begin() + tests / 2;
  std::nth_element(scratch.begin(), middle, end);
  return std::sqrt(*middle) / kMedianOfAbsoluteNormal;
}

bool mayShowNoiseAbove(const RaySoA& rays, double sigma_m)
{
  constexpr int kSmallestStep = 3;  // tests that share no ray
  constexpr int kEnoughTests = 60;
  constexpr double kMargin = 0.8;  // for the scatter of the median of so many
  const double median_m = std::min(kEdge_m, kMargin * kMedianOfAbsoluteNormal * sigma_m);
  const int step = std::max(kSmallestStep, rays.rays / kEnoughTests);
  const ThreeRays test(rays);
  int tests = 0, below = 0;
  for (int p = 1; p < rays.rays - 1; p += step)
  {
    const Fraction f = test.at(p - 1, p, p + 1);
    const bool counts = test.valid(p - 1, p, p + 1) & (f.square <= kEdge_m * kEdge_m * f.variance);
    tests += counts;
    below += counts & (f.square <= median_m * median_m * f.variance);
  }
  return 2 * below <= tests;
}

int strongestBreak(const RaySoA& rays)
{
  const ThreeRays test(rays);
  int strongest = 0;
  double largest_m2 = -1;
  for (int p = 0; p < rays.rays; ++p)
  {
    const int before = p > 0 ? p - 1 : rays.rays - 1, after = p + 1 < rays.rays ? p + 1 : 0;
    if (!rays.valid(p) || !rays.valid(after)) continue;
    if (!rays.valid(before)) return p;
    const Fraction f = test.atEvenNoise(before, p, after);
    if (f.square <= largest_m2 * f.variance) continue;
    largest_m2 = f.square / f.variance;
    strongest = p;
  }
  return strongest;
}
}  // namespace psmks
