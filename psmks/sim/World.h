/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Line.h>
#include <psmks/core/Pose2.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace psmks
{
/** Straight, opaque walls in the plane, metres, and what a ray meets among them. */
class World
{
 public:
  struct Wall
  {
    Eigen::Vector2d a, b;
  };

  struct Hit
  {
    static constexpr int kNothing = -1;
    double range_m;
    int wall;  //!< index into walls(), or kNothing
  };

  World() = default;
  explicit World(std::vector<Wall> walls) : walls_(std::move(walls)) {}

  /** A room of 14 x 11 m about the origin with 7 boxes parallel to its walls: 32 walls. */
  static World room();

  /** The same room with 16 boxes of random place, size and angle instead: 68 walls. The same seed
   *  gives the same world. */
  static World clutter(unsigned seed);

  const std::vector<Wall>& walls() const { return walls_; }

  /** The nearest wall along a ray, exactly; a wall beyond maxRange_m is nothing.
   *  @param direction unit vector */
  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
           double maxRange_m) const;

  /** The line that a wall lies on as a sensor there sees it, without covariance. */
  Line lineFrom(int wall, const Pose2& T_world_sensor) const;

  /** Distance from a point to the nearest wall; infinity in an empty world. */
  double clearance_m(const Eigen::Vector2d& point_m) const;

  /** True inside the room and outside its boxes, where all of them are closed outlines. */
  bool isFree(const Eigen::Vector2d& point_m) const;

  /** A pose anywhere in the free space, heading anywhere, at least this far from every wall. */
  Pose2 randomFreePose(double minClearance_m, std::mt19937_64& random) const;

  /** Adds the outline of a box that is turned by phi_rad about its centre. */
  void addBox(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& size_m, double phi_rad = 0);

 private:
  std::vector<Wall> walls_;
};
}  // namespace psmks
