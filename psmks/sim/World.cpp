/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/World.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
const Eigen::Vector2d kRoomSize_m(14, 11);

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Range at which a ray meets a wall, infinity where it does not.
 *
 * origin + range * direction = a + share * (b - a), 0 <= share <= 1; solved by crossing both sides
 * with (b - a) and with direction. */
double rangeTo_m(const World::Wall& wall, const Eigen::Vector2d& origin_m,
                 const Eigen::Vector2d& direction)
{
  const Eigen::Vector2d along = wall.b - wall.a, toWall = wall.a - origin_m;
  const double slope = cross(direction, along);
  const double range_m = cross(toWall, along) / slope;
  const double share = cross(toWall, direction) / slope;
  const bool meets = slope != 0 && range_m > 0 && share >= 0 && share <= 1;
  return meets ? range_m : std::numeric_limits<double>::infinity();
}

double distance_m(const World::Wall& wall, const Eigen::Vector2d& point_m)
{
  const Eigen::Vector2d along = wall.b - wall.a;
  const double share = std::clamp((point_m - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (wall.a + share * along - point_m).norm();
}
}  // namespace

//   +--------------------------------------------+  11 m
//   |    +----+          +--+                    |
//   |    +----+          |  |          +---+     |
//   |           +--+     +--+          +---+     |
//   |           |  |      +------+               |
//   |           +--+      +------+               |
//   |     +---+                     +--+         |
//   |     +---+                     |  |         |
//   |                               +--+         |
//   +--------------------------------------------+  0 to 14 m
World World::smallRoom()
{
  World world;
  world.addBox({0, 0}, kRoomSize_m);
  world.addBox({-4.8, 3.4}, {1.8, 1.0});
  world.addBox({0.2, 3.6}, {1.2, 1.6});
  world.addBox({4.6, 3.0}, {1.6, 1.4});
  world.addBox({-2.6, 0.2}, {1.0, 1.8});
  world.addBox({2.4, -0.4}, {2.0, 0.9});
  world.addBox({-4.4, -3.2}, {1.4, 1.2});
  world.addBox({3.8, -3.6}, {0.9, 1.5});
  return world;
}

World World::smallClutter(unsigned seed)
{
  constexpr std::size_t kWalls = 4 + 16 * 4;
  constexpr double kGap_m = 0.9;  // between a box and everything placed before it
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> side_m(0.3, 0.8), angle_rad(-kPi, kPi);

  World world;
  world.addBox({0, 0}, kRoomSize_m);
  while (world.walls_.size() < kWalls)
  {
    const Eigen::Vector2d size_m(side_m(random), side_m(random));
    const Pose2 place = world.randomFreePose(kGap_m + size_m.norm() / 2, random);
    world.addBox(place.translation(), size_m, angle_rad(random));
  }
  return world;
}

Hit World::cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                double maxRange_m, double /*time_s*/) const
{
  Hit nearest{maxRange_m, Hit::kNothing};
  for (std::size_t w = 0; w < walls_.size(); ++w)
  {
    const double range_m = rangeTo_m(walls_[w], origin_m, direction);
    if (range_m < nearest.range_m) nearest = {range_m, static_cast<int>(w)};
  }
  return nearest;
}

Line World::lineFrom(int wall, const Pose2& T_world_sensor) const
{
  const Wall& w = walls_[static_cast<std::size_t>(wall)];
  const Eigen::Vector2d along = (w.b - w.a).normalized();
  const Eigen::Vector2d normal(-along.y(), along.x());
  const Line line = Line::fromNormalForm(normal.dot(w.a), std::atan2(normal.y(), normal.x()),
                                         Eigen::Matrix2d::Zero());
  return line.transformed(T_world_sensor.inverse());
}

double World::clearance_m(const Eigen::Vector2d& point_m, double limit_m, double /*time_s*/) const
{
  double nearest_m = limit_m;
  for (const Wall& wall : walls_) nearest_m = std::min(nearest_m, distance_m(wall, point_m));
  return nearest_m;
}

// A ray to the right leaves the room once, and every box before it either not at all or once in and
// once out: an odd number of walls. From inside a box it is an even one.
bool World::isFree(const Eigen::Vector2d& point_m) const
{
  const auto crosses = [&point_m](const Wall& wall)
  { return std::isfinite(rangeTo_m(wall, point_m, Eigen::Vector2d::UnitX())); };
  return std::count_if(walls_.begin(), walls_.end(), crosses) % 2 == 1;
}

Pose2 World::randomFreePose(double minClearance_m, std::mt19937_64& random) const
{
  Eigen::Vector2d low_m = walls_.front().a, high_m = low_m;
  for (const Wall& wall : walls_)
  {
    low_m = low_m.cwiseMin(wall.a).cwiseMin(wall.b);
    high_m = high_m.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  std::uniform_real_distribution<double> x_m(low_m.x(), high_m.x()), y_m(low_m.y(), high_m.y());
  std::uniform_real_distribution<double> phi_rad(-kPi, kPi);
  while (true)
  {
    const double x = x_m(random), y = y_m(random);
    const Pose2 pose{x, y, phi_rad(random)};
    if (isFree(pose.translation()) &&
        clearance_m(pose.translation(), minClearance_m, 0) >= minClearance_m)
      return pose;
  }
}

void World::addBox(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& size_m, double phi_rad)
{
  const Pose2 T_world_box{centre_m.x(), centre_m.y(), phi_rad};
  const Eigen::Vector2d half_m = size_m / 2;
  const std::array<Eigen::Vector2d, 4> corners{
      T_world_box * Eigen::Vector2d(-half_m.x(), -half_m.y()),
      T_world_box * Eigen::Vector2d(half_m.x(), -half_m.y()), T_world_box * half_m,
      T_world_box * Eigen::Vector2d(-half_m.x(), half_m.y())};
  for (std::size_t c = 0; c < corners.size(); ++c)
    walls_.push_back({corners[c], corners[(c + 1) % corners.size()]});
}
}  // namespace psmks
