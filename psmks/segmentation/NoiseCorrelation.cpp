/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/NoiseCorrelation.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
void NoiseCorrelation::add(const LineFit& fit)
{
  /** What the fit of a line takes from the sum of products of neighbouring residuals. Unit:
   * variances. Definition: each of its two parameters takes about one. */
  constexpr double kTaken = 2;
  products_ += fit.whiteness * std::sqrt(fit.rays) + kTaken;
  squares_ += fit.chi2;
  rays_ += fit.rays;
}

double NoiseCorrelation::raysPerReading() const
{
  /** Largest correlation that counts. Unit: none. Definition: means of ten rays, more than the
   * shortest lines have. */
  constexpr double kLargest = 0.9;
  if (!(squares_ > 0)) return 1;
  const double correlation = products_ / squares_ - 1 / std::sqrt(rays_);
  return 1 / (1 - std::clamp(correlation, 0.0, kLargest));
}
}  // namespace psmks
