/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/MovingObject.h>

#include <cmath>

namespace psmks
{
namespace
{
using Path = std::vector<Eigen::Vector2d>;

double length_m(const Path& path_m)
{
  double sum_m = 0;
  for (std::size_t i = 1; i < path_m.size(); ++i) sum_m += (path_m[i] - path_m[i - 1]).norm();
  return sum_m;
}

/** The place at a distance along a path. */
Eigen::Vector2d along(const Path& path_m, double way_m)
{
  for (std::size_t i = 1; i < path_m.size(); ++i)
  {
    const Eigen::Vector2d leg = path_m[i] - path_m[i - 1];
    if (way_m < leg.norm()) return path_m[i - 1] + way_m * leg.normalized();
    way_m -= leg.norm();
  }
  return path_m.back();
}
}  // namespace

Eigen::Vector2d MovingObject::place_m(double time_s) const
{
  const double oneWay_m = length_m(path_m);
  if (oneWay_m == 0) return path_m.front();
  const double way_m = std::fmod(speed_mps * time_s, 2 * oneWay_m);
  return along(path_m, way_m <= oneWay_m ? way_m : 2 * oneWay_m - way_m);
}
}  // namespace psmks
