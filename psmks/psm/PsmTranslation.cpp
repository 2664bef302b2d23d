/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmTranslation.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
namespace
{
/** Determinant of the normal equations below which they fix no position. Unit: squared weight.
 * Definition: a ray weighs at most 1; below 0.001 not even a thousandth of a ray fixes the worse
 * direction. */
constexpr double kSingular = 1e-3;
}  // namespace

PsmTranslation solvePsmTranslation(const PsmScan& reference, const PsmProjection& projection,
                                   double weightScale_m, const PsmOptions& options)
{
  const double c_m2 = weightScale_m * weightScale_m;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d side = Eigen::Vector2d::Zero();
  PsmTranslation result;
  for (int i = 0; i < reference.rays(); ++i)
  {
    const auto p = static_cast<std::size_t>(i);
    const double projected_m = projection.range_m[p];
    if (projection.tag[p] != PsmTag::Good || !reference.isGood(i)) continue;
    if (projected_m < options.minProjectedRange_m || projected_m > reference.maxRange_m) continue;
    const double d_m = reference.range(i) - projected_m;
    if (std::abs(d_m) >= options.maxPairDifference_m) continue;

    const double weight = c_m2 / (d_m * d_m + c_m2);
    const Eigen::Vector2d slope = reference.grid.direction(i);
    normal += weight * slope * slope.transpose();
    side += weight * d_m * slope;
    ++result.pairs;
  }
  result.solvable = normal.determinant() > kSingular;
  if (result.solvable) result.step_m = normal.inverse() * side;
  return result;
}
}  // namespace psmks
