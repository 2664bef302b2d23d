/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/ThreeRayTest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
double threeRayTest_m(const SegmentedScan& scan, int ray)
{
  constexpr double kMissing = std::numeric_limits<double>::infinity();
  const int before = scan.grid.neighbour(ray, -1);
  const int after = scan.grid.neighbour(ray, 1);
  if (before < 0 || after < 0) return kMissing;
  if (!scan.isValid(before) || !scan.isValid(ray) || !scan.isValid(after)) return kMissing;

  const double twoCosine = 2 * std::cos(scan.grid.increment_rad());
  const double a = 1 / scan.range_m[static_cast<std::size_t>(before)];
  const double b = 1 / scan.range_m[static_cast<std::size_t>(ray)];
  const double c = 1 / scan.range_m[static_cast<std::size_t>(after)];
  // sd(1/r) = sigma / r^2 for each ray
  const double unitSigma =
      std::sqrt(a * a * a * a + twoCosine * twoCosine * b * b * b * b + c * c * c * c);
  return (a - twoCosine * b + c) / unitSigma;
}

double estimateRangeSigma_m(const SegmentedScan& scan, std::vector<double>& scratch)
{
  constexpr int kFewestTests = 20;
  constexpr double kMedianOfAbsoluteNormal = 0.6745;
  scratch.clear();
  for (int i = 0; i < scan.rays(); ++i)
  {
    const double test_m = threeRayTest_m(scan, i);
    if (std::isfinite(test_m)) scratch.push_back(std::abs(test_m));
  }
  if (scratch.size() < kFewestTests) return 0;
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return *middle / kMedianOfAbsoluteNormal;
}

int strongestBreak(const SegmentedScan& scan)
{
  int strongest = 0;
  double largest_m = -1;
  for (int i = 0; i < scan.rays(); ++i)
  {
    const double test_m = std::abs(threeRayTest_m(scan, i));
    if (test_m > largest_m)
    {
      largest_m = test_m;
      strongest = i;
    }
  }
  return strongest;
}
}  // namespace psmks
