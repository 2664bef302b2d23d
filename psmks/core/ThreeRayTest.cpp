/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/ThreeRayTest.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
class ThreeRays
{
 public:
  explicit ThreeRays(const BeamGrid& grid) : twoCosine_(2 * std::cos(grid.increment_rad())) {}

  /** @param a, b, c inverse ranges of a ray and its neighbours */
  double squared_m2(double a, double b, double c) const
  {
    // var(1/r) = sigma^2 / r^4 for each ray
    const double a2 = a * a, b2 = b * b, c2 = c * c;
    const double variance = a2 * a2 + twoCosine_ * twoCosine_ * b2 * b2 + c2 * c2;
    const double sum = a - twoCosine_ * b + c;
    return sum * sum / variance;
  }

 private:
  double twoCosine_;
};
}  // namespace

void threeRayTests(const SegmentedScan& scan, const std::vector<double>& inverseRange_1_m,
                   std::vector<double>& tests_m2)
{
  const ThreeRays test(scan.grid);
  tests_m2.clear();
  for (std::size_t i = 1; i + 1 < inverseRange_1_m.size(); ++i)
    if (scan.valid[i - 1] && scan.valid[i] && scan.valid[i + 1])
      tests_m2.push_back(
          test.squared_m2(inverseRange_1_m[i - 1], inverseRange_1_m[i], inverseRange_1_m[i + 1]));
}

double estimateRangeSigma_m(const SegmentedScan& scan, const std::vector<double>& inverseRange_1_m,
                            std::vector<double>& scratch)
{
  constexpr std::ptrdiff_t kFewestTests = 20;
  constexpr double kEdge_m = 0.2;  // a test beyond it is a jump or a corner, not noise
  constexpr double kMedianOfAbsoluteNormal = 0.6745;
  threeRayTests(scan, inverseRange_1_m, scratch);
  const auto end = std::partition(scratch.begin(), scratch.end(),
                                  [](double test_m2) { return test_m2 <= kEdge_m * kEdge_m; });
  const auto tests = end - scratch.begin();
  if (tests < kFewestTests) return 0;
  const auto middle = scratch.begin() + tests / 2;
  std::nth_element(scratch.begin(), middle, end);
  return std::sqrt(*middle) / kMedianOfAbsoluteNormal;
}

int strongestBreak(const SegmentedScan& scan, const std::vector<double>& inverseRange_1_m)
{
  const ThreeRays test(scan.grid);
  int strongest = 0;
  double largest_m2 = -1;
  for (int i = 0; i < scan.rays(); ++i)
  {
    const int before = scan.grid.neighbour(i, -1), after = scan.grid.neighbour(i, 1);
    if (!scan.isValid(i) || !scan.isValid(after)) continue;
    if (!scan.isValid(before)) return i;
    const auto inverse = [&](int ray) { return inverseRange_1_m[static_cast<std::size_t>(ray)]; };
    const double test_m2 = test.squared_m2(inverse(before), inverse(i), inverse(after));
    if (test_m2 <= largest_m2) continue;
    largest_m2 = test_m2;
    strongest = i;
  }
  return strongest;
}
}  // namespace psmks
