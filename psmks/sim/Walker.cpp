/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/sim/Walker.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
// Free discs at a distance of one stride cover the straight line but for narrow gaps between them.
bool isPathFree(const Surroundings& surroundings, const Eigen::Vector2d& from_m,
                const Eigen::Vector2d& to_m, double radius_m)
{
  constexpr double kStride_m = 0.1;
  const double length_m = (to_m - from_m).norm();
  const Eigen::Vector2d direction = (to_m - from_m).normalized();
  for (double way_m = kStride_m; way_m < length_m + kStride_m; way_m += kStride_m)
  {
    const Eigen::Vector2d point_m = from_m + std::min(way_m, length_m) * direction;
    if (surroundings.clearance_m(point_m, radius_m, 0) < radius_m) return false;
  }
  return true;
}

bool Walker::walkOn()
{
  constexpr int kTries = 100;
  std::uniform_real_distribution<double> angle_rad(-kPi, kPi);
  std::uniform_real_distribution<double> length_m(options_.shortestWay_m, options_.longestWay_m);
  for (int i = 0; i < kTries; ++i)
  {
    const double angle = angle_rad(random_);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d end_m = place_m() + length_m(random_) * direction;
    if (!isPathFree(surroundings_, place_m(), end_m, options_.clearance_m)) continue;
    path_m_.push_back(end_m);
    return true;
  }
  return false;
}

bool Walker::walkOn(int ways)
{
  for (int way = 0; way < ways; ++way)
    if (!walkOn()) return false;
  return true;
}
}  // namespace psmks
