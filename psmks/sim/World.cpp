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

}  // namespace

// Solves origin + range * direction = a + share * (b - a) with 0 <= share <= 1. The cross products
// of both sides with (b - a) and with direction give range and share, each times the same slope, so
// that only a hit needs a division.
double World::Wall::rangeAlong_m(const Eigen::Vector2d& origin_m,
                                 const Eigen::Vector2d& direction) const
{
  const Eigen::Vector2d along = b - a, toWall = a - origin_m;
  const double slope = cross(direction, along), sign = slope < 0 ? -1 : 1;
  const double share = sign * cross(toWall, direction), range = sign * cross(toWall, along);
  const bool meets = slope != 0 && range > 0 && share >= 0 && share <= std::abs(slope);
  return meets ? range / std::abs(slope) : std::numeric_limits<double>::infinity();
}

double World::Wall::distance_m(const Eigen::Vector2d& point_m) const
{
  const Eigen::Vector2d along = b - a;
  const double length2_m2 = along.squaredNorm();
  const double share =
      length2_m2 > 0 ? std::clamp((point_m - a).dot(along) / length2_m2, 0.0, 1.0) : 0;
  return (a + share * along - point_m).norm();
}

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
  constexpr double kGap_m = 0.9;  // between a box and all those placed before it
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

int World::objectOf(const Point& point) const
{
  if (point.circle == Point::kNoCircle) return kIsolatedPoint;
  return static_cast<int>(walls_.size()) + point.circle;
}

int World::objectOfMoving(std::size_t movingObject) const
{
  return static_cast<int>(walls_.size() + circles_.size() + movingObject);
}

Hit World::cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                double maxRange_m, double time_s) const
{
  Hit nearest{maxRange_m, Hit::kNothing};
  for (std::size_t w = 0; w < walls_.size(); ++w)
    nearest.take(walls_[w].rangeAlong_m(origin_m, direction), static_cast<int>(w));
  for (const Point& point : points_)
    nearest.take(point.disc().rangeAlong_m(origin_m, direction), objectOf(point));
  return castAtMoving(origin_m, direction, nearest, time_s);
}

Hit World::castAtMoving(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                        const Hit& nearest, double time_s) const
{
  Hit hit = nearest;
  for (std::size_t i = 0; i < movingObjects_.size(); ++i)
    hit.take(movingObjects_[i].disc(time_s).rangeAlong_m(origin_m, direction), objectOfMoving(i));
  return hit;
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

double World::clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const
{
  double nearest_m = limit_m;
  for (const Wall& wall : walls_) nearest_m = std::min(nearest_m, wall.distance_m(point_m));
  for (const Point& point : points_)
    nearest_m = std::min(nearest_m, point.disc().distance_m(point_m));
  return clearanceOfMoving_m(point_m, nearest_m, time_s);
}

double World::clearanceOfMoving_m(const Eigen::Vector2d& point_m, double limit_m,
                                  double time_s) const
{
  double nearest_m = limit_m;
  for (const MovingObject& object : movingObjects_)
    nearest_m = std::min(nearest_m, object.disc(time_s).distance_m(point_m));
  return nearest_m;
}

// A ray to the right crosses an odd number of walls if the point is in the room and outside the
// boxes: it leaves the room once, and crosses a box not at all or twice. From inside a box the
// number is even.
bool World::isFree(const Eigen::Vector2d& point_m) const
{
  const auto crosses = [&point_m](const Wall& wall)
  { return std::isfinite(wall.rangeAlong_m(point_m, Eigen::Vector2d::UnitX())); };
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

void World::addArc(const Circle& circle, double first_rad, double last_rad, int points)
{
  const int index = static_cast<int>(circles_.size());
  circles_.push_back(circle);
  constexpr double kSameAngle_rad = 1e-9;
  const bool closed = std::abs(last_rad - first_rad) > 2 * kPi - kSameAngle_rad;
  const double step_rad = (last_rad - first_rad) / std::max(1, closed ? points : points - 1);
  for (int i = 0; i < points; ++i)
  {
    const double angle_rad = first_rad + i * step_rad;
    const Eigen::Vector2d outward(std::cos(angle_rad), std::sin(angle_rad));
    points_.push_back({circle.centre_m + circle.radius_m * outward, index});
  }
}
}  // namespace psmks
