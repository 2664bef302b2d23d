/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmMatchError.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
using Points = std::vector<Eigen::Vector2d>;

/** Distance of a point to which there is no other. Definition: farther than any point. */
constexpr double kNothing_m = std::numeric_limits<double>::infinity();

Points goodPoints(const PsmScan& scan, const Pose2& T_to_scan)
{
  const Eigen::Matrix2d rotation = T_to_scan.rotation();
  Points points;
  for (int i = 0; i < scan.rays(); ++i)
    if (scan.isGood(i)) points.push_back(rotation * scan.point(i) + T_to_scan.translation());
  return points;
}

double meanNearestDistance_m(const Points& from, const Points& to)
{
  if (from.empty()) return kNothing_m;
  double sum_m = 0;
  for (const Eigen::Vector2d& p : from)
  {
    double nearest_m2 = kNothing_m;
    for (const Eigen::Vector2d& q : to) nearest_m2 = std::min(nearest_m2, (p - q).squaredNorm());
    sum_m += std::sqrt(nearest_m2);
  }
  return sum_m / static_cast<double>(from.size());
}
}  // namespace

double rangeErrorIndex_m(const PsmScan& reference, const PsmProjection& projection,
                         double maxPairDifference_m)
{
  double sum_m = 0;
  int pairs = 0;
  for (int i = 0; i < reference.rays(); ++i)
  {
    const auto p = static_cast<std::size_t>(i);
    if (projection.tag[p] != PsmTag::Good || !reference.isGood(i)) continue;
    const double d_m = std::abs(reference.range(i) - projection.range_m[p]);
    if (d_m >= maxPairDifference_m / 2) continue;
    sum_m += d_m;
    ++pairs;
  }
  return pairs > 0 ? sum_m / pairs : kNothing_m;
}

double pointErrorIndex_m(const PsmScan& reference, const PsmScan& current, const Pose2& T_ref_cur)
{
  const Points fixed = goodPoints(reference, {});
  const Points moved = goodPoints(current, T_ref_cur);
  return std::max(meanNearestDistance_m(fixed, moved), meanNearestDistance_m(moved, fixed));
}
}  // namespace psmks
