/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/sim/Disc.h>
#include <psmks/sim/MovingObject.h>
#include <psmks/sim/Surroundings.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace psmks
{
/** A plane with opaque objects: straight walls, points and moving objects. It is plain data and
 * answers by looking at all objects; WorldIndex gives the same answers fast. */
class World : public Surroundings
{
 public:
  struct Wall
  {
    Eigen::Vector2d a, b;

    /** The range at which a ray meets the wall, or infinity if it does not.
     *  @param direction unit vector */
    double rangeAlong_m(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction) const;

    double distance_m(const Eigen::Vector2d& point_m) const;
  };

  /** A circle that some of the points lie on. */
  struct Circle
  {
    Eigen::Vector2d centre_m;
    double radius_m;
  };

  /** A point. It is a small disc, so that rays can meet it. */
  struct Point
  {
    static constexpr int kNoCircle = -1;
    Eigen::Vector2d centre_m;
    int circle = kNoCircle;  //!< index into circles()

    Disc disc() const { return {centre_m, kPointRadius_m}; }
  };

  static constexpr double kPointRadius_m = 0.01;

  /** The value of Hit::object for a point that lies on no circle. Walls have the numbers from 0 on,
   * then follow the circles, then the moving objects. */
  static constexpr int kIsolatedPoint = 1 << 30;

  World() = default;
  explicit World(std::vector<Wall> walls) : walls_(std::move(walls)) {}

  /** A room of 14 x 11 m about the origin with 7 boxes parallel to its walls. It has 32 walls. */
  static World smallRoom();

  /** The room of smallRoom() with 16 boxes of random place, size and angle instead. It has 68
   * walls. The same seed gives the same world. */
  static World smallClutter(unsigned seed);

  const std::vector<Wall>& walls() const { return walls_; }
  const std::vector<Circle>& circles() const { return circles_; }
  const std::vector<Point>& points() const { return points_; }
  const std::vector<MovingObject>& movingObjects() const { return movingObjects_; }

  /** The value of Hit::object for a point. */
  int objectOf(const Point& point) const;
  int objectOfMoving(std::size_t movingObject) const;

  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction, double maxRange_m,
           double time_s) const override;
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const override;

  /** Casts a ray at the moving objects alone.
   *  @param nearest what the ray has met so far; returned if no moving object is nearer */
  Hit castAtMoving(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                   const Hit& nearest, double time_s) const;
  double clearanceOfMoving_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const;

  /** The line of a wall in the frame of a sensor, with zero covariance. */
  Line lineFrom(int wall, const Pose2& T_world_sensor) const;

  /** Whether a point is inside the room and outside its boxes. All outlines must be closed. */
  bool isFree(const Eigen::Vector2d& point_m) const;

  /** A random pose in the free space that keeps the given distance from all objects. */
  Pose2 randomFreePose(double minClearance_m, std::mt19937_64& random) const;

  void addWall(const Wall& wall) { walls_.push_back(wall); }

  /** Adds the outline of a box that is turned by phi_rad about its centre. */
  void addBox(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& size_m, double phi_rad = 0);

  void addPoint(const Eigen::Vector2d& centre_m)
  {
    points_.push_back({centre_m, Point::kNoCircle});
  }

  /** Adds points on an arc of a circle, evenly spaced from the first angle to the last, both
   * included. On a full turn the last point would coincide with the first and is left out. */
  void addArc(const Circle& circle, double first_rad, double last_rad, int points);

  void addMovingObject(MovingObject object) { movingObjects_.push_back(std::move(object)); }

 private:
  std::vector<Wall> walls_;
  std::vector<Circle> circles_;
  std::vector<Point> points_;
  std::vector<MovingObject> movingObjects_;
};
}  // namespace psmks
