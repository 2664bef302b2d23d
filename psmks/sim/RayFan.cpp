/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/RayFan.h>
#include <psmks/sim/World.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Includes the outer rays of a scanner of 180 degrees. */
constexpr double kForward_rad = degToRad(90.5);

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double area_m2(const RayFan::End& right, const RayFan::End& left)
{
  return cross(right.point_m, left.point_m) / 2;
}

// The source takes the logarithm of a length in millimetres. It varies little, so that far places
// weigh only a little more than their area.
double weight(const RayFan::End& right, const RayFan::End& left)
{
  constexpr double kMillimetres = 1000;
  return area_m2(right, left) * std::log1p(kMillimetres * (right.range_m + left.range_m) / 2);
}
}  // namespace

RayFan::RayFan(const Scan& scan, const Pose2& T_robot_sensor, double farthest_m)
{
  for (int ray = 0; ray < scan.grid.count(); ++ray)
  {
    const double measured_m = scan.range_m[static_cast<std::size_t>(ray)];
    const double range_m = measured_m > 0 ? std::min(measured_m, farthest_m) : farthest_m;
    const Eigen::Vector2d point_m = T_robot_sensor * (range_m * scan.grid.direction(ray));
    const End end{point_m, std::atan2(point_m.y(), point_m.x()), point_m.norm()};
    if (std::abs(end.bearing_rad) <= kForward_rad) ends_.push_back(end);
  }
  std::stable_sort(ends_.begin(), ends_.end(),
                   [](const End& a, const End& b) { return a.bearing_rad < b.bearing_rad; });
}

RayFan RayFan::sector(double right_rad, double left_rad) const
{
  RayFan part;
  for (const End& end : ends_)
    if (end.bearing_rad >= right_rad && end.bearing_rad <= left_rad) part.ends_.push_back(end);
  return part;
}

RayFan RayFan::clipped(double reach_m) const
{
  RayFan shorter = *this;
  for (End& end : shorter.ends_)
  {
    if (end.range_m <= reach_m) continue;
    end.point_m *= reach_m / end.range_m;
    end.range_m = reach_m;
  }
  return shorter;
}

double RayFan::area_m2() const
{
  double sum_m2 = 0;
  for (std::size_t e = 1; e < ends_.size(); ++e) sum_m2 += psmks::area_m2(ends_[e - 1], ends_[e]);
  return sum_m2;
}

double RayFan::halfAngle_rad() const
{
  return ends_.empty() ? 0 : (ends_.back().bearing_rad - ends_.front().bearing_rad) / 2;
}

double RayFan::meanRange_m() const
{
  double sum_m = 0;
  for (const End& end : ends_) sum_m += end.range_m;
  return ends_.empty() ? 0 : sum_m / count();
}

Eigen::Vector2d RayFan::areaCentre_m() const
{
  Eigen::Vector2d sum(0, 0);
  double weights = 0;
  for (std::size_t e = 1; e < ends_.size(); ++e)
  {
    const End &right = ends_[e - 1], &left = ends_[e];
    const Eigen::Vector2d centroid_m = (right.point_m + left.point_m) / 3;
    sum += weight(right, left) * centroid_m;
    weights += weight(right, left);
  }
  return weights > 0 ? Eigen::Vector2d(sum / weights) : sum;
}

double RayFan::outlineDistance_m(const Eigen::Vector2d& place_m) const
{
  double nearest_m = kInfinity;
  for (std::size_t e = 1; e < ends_.size(); ++e)
  {
    const World::Wall edge{ends_[e - 1].point_m, ends_[e].point_m};
    nearest_m = std::min(nearest_m, edge.distance_m(place_m));
  }
  return nearest_m;
}

double RayFan::clearance_m(const Eigen::Vector2d& place_m) const
{
  double nearest_m = kInfinity;
  for (const End& end : ends_) nearest_m = std::min(nearest_m, (end.point_m - place_m).norm());
  return nearest_m;
}

double RayFan::pathClearance_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const
{
  const World::Wall way{from_m, to_m};
  double nearest_m = kInfinity;
  for (const End& end : ends_) nearest_m = std::min(nearest_m, way.distance_m(end.point_m));
  return nearest_m;
}

double RayFan::lane_m(double bearing_rad, double width_m) const
{
  double free_m = 0;
  for (const End& end : ends_) free_m = std::max(free_m, end.range_m);
  for (const End& end : ends_)
  {
    const double aside_rad = end.bearing_rad - bearing_rad;
    const double along_m = end.range_m * std::cos(aside_rad);
    const double across_m = end.range_m * std::sin(aside_rad);
    if (along_m > 0 && std::abs(across_m) < width_m / 2) free_m = std::min(free_m, along_m);
  }
  return free_m;
}
}  // namespace psmks
