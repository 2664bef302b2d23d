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
/** A plane of opaque things: straight walls, points, and objects that move. Plain data that answers
 * by looking at everything; WorldIndex answers the same fast. */
class World : public Surroundings
{
 public:
  struct Wall
  {
    Eigen::Vector2d a, b;

    /** Range at which a ray meets it, infinity where it does not.
     *  @param direction unit vector */
    double rangeAlong_m(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction) const;

    double distance_m(const Eigen::Vector2d& point_m) const;
  };

  /** Some of the points may lie on a common circle. */
  struct Circle
  {
    Eigen::Vector2d centre_m;
    double radius_m;
  };

  /** A point is a disc, so that rays can meet it. */
  struct Point
  {
    static constexpr int kNoCircle = -1;
    Eigen::Vector2d centre_m;
    int circle = kNoCircle;  //!< index into circles()

    Disc disc() const { return {centre_m, kPointRadius_m}; }
  };

  static constexpr double kPointRadius_m = 0.01;

  /** Hit::object counts through the walls, then the circles, then the moving objects; a point that
   * lies on no circle is kLonePoint. */
  static constexpr int kLonePoint = 1 << 30;

  World() = default;
  explicit World(std::vector<Wall> walls) : walls_(std::move(walls)) {}

  /** A room of 14 x 11 m about the origin with 7 boxes parallel to its walls: 32 walls. */
  static World smallRoom();

  /** The same room with 16 boxes of random place, size and angle instead: 68 walls. The same seed
   *  gives the same world. */
  static World smallClutter(unsigned seed);

  const std::vector<Wall>& walls() const { return walls_; }
  const std::vector<Circle>& circles() const { return circles_; }
  const std::vector<Point>& points() const { return points_; }
  const std::vector<MovingObject>& movingObjects() const { return movingObjects_; }

  /** The number that a hit on one of them has. */
  int objectOf(const Point& point) const;
  int objectOfMoving(std::size_t movingObject) const;

  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction, double maxRange_m,
           double time_s) const override;
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const override;

  /** The same for the moving objects alone.
   *  @param nearest what the ray has met so far, taken over where nothing is nearer */
  Hit castAtMoving(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                   const Hit& nearest, double time_s) const;
  double clearanceOfMoving_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const;

  /** The line that a wall lies on as a sensor there sees it, without covariance. */
  Line lineFrom(int wall, const Pose2& T_world_sensor) const;

  /** True inside the room and outside its boxes, where all of them are closed outlines. */
  bool isFree(const Eigen::Vector2d& point_m) const;

  /** A pose anywhere in the free space, heading anywhere, at least this far from everything. */
  Pose2 randomFreePose(double minClearance_m, std::mt19937_64& random) const;

  void addWall(const Wall& wall) { walls_.push_back(wall); }

  /** Adds the outline of a box that is turned by phi_rad about its centre. */
  void addBox(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& size_m, double phi_rad = 0);

  void addPoint(const Eigen::Vector2d& centre_m)
  {
    points_.push_back({centre_m, Point::kNoCircle});
  }

  /** Adds points on an arc of a circle, evenly spaced from one angle to the other, both ends
   * included; on a full turn the last point, which would meet the first one, is left out. */
  void addArc(const Circle& circle, double first_rad, double last_rad, int points);

  void addMovingObject(MovingObject object) { movingObjects_.push_back(std::move(object)); }

 private:
  std::vector<Wall> walls_;
  std::vector<Circle> circles_;
  std::vector<Point> points_;
  std::vector<MovingObject> movingObjects_;
};
}  // namespace psmks
