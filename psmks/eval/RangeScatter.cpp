/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/RangeScatter.h>
#include <psmks/eval/Statistics.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace psmks
{
void RangeScatter::add(double range_m, double error_m)
{
  /** Range from which on errors are left out. Definition: farther than 2D scanners see. */
  constexpr double kFarthest_m = 1000;
  if (!(range_m >= 0 && range_m < kFarthest_m) || !std::isfinite(error_m)) return;
  const auto metre = static_cast<std::size_t>(range_m);
  if (metre >= metres_.size()) metres_.resize(metre + 1);
  metres_[metre].sumOfRanges_m += range_m;
  metres_[metre].absolute_m.push_back(std::abs(error_m));
}

std::vector<RangeScatter::Bin> RangeScatter::bins() const
{
  /** Fewest errors that tell a scatter. Unit: errors. Definition: to about 10 %. */
  constexpr std::size_t kFewest = 100;

  /** Share of normal errors below their standard deviation. Unit: share. Definition: of the normal
   * distribution. */
  constexpr double kNormal = 0.6827;
  std::vector<Bin> bins;
  for (const Errors& errors : metres_)
  {
    const std::size_t count = errors.absolute_m.size();
    if (count < kFewest) continue;
    bins.push_back({errors.sumOfRanges_m / static_cast<double>(count),
                    quantile(errors.absolute_m, kNormal), static_cast<int>(count)});
  }
  return bins;
}

RangeNoise RangeScatter::noise() const
{
  // Least squares for a and b of v = a + b r^2, v the variance of a bin.
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  for (const Bin& bin : bins())
  {
    const double variance_m2 = std::max(bin.sigma_m * bin.sigma_m, 1e-12);
    const double weight = bin.errors / (variance_m2 * variance_m2);
    const Eigen::Vector2d row(1, bin.range_m * bin.range_m);
    A += weight * row * row.transpose();
    y += weight * variance_m2 * row;
  }
  if (!(A(0, 0) > 0)) return {};
  Eigen::Vector2d best = A.determinant() > 1e-9 * A(0, 0) * A(1, 1)
                             ? Eigen::Vector2d(A.inverse() * y)
                             : Eigen::Vector2d(y.x() / A(0, 0), 0);
  if (best.y() < 0) best = {y.x() / A(0, 0), 0};
  if (best.x() < 0) best = {0, y.y() / A(1, 1)};
  return {std::sqrt(best.x()), std::sqrt(best.y())};
}
}  // namespace psmks
