/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** What a ray met. */
struct Hit
{
  static constexpr int kNothing = -1;  //!< there is no object within the range
  double range_m = 0;                  //!< the maximum range if nothing was met
  int object = kNothing;  //!< see World::objectOf(); other surroundings use any numbers >= 0

  /** Replaces the hit by another one if that is nearer. Of two objects at the same range the one
   * with the lower number counts, so that the result does not depend on the order. */
  void take(double otherRange_m, int otherObject)
  {
    const bool nearer = otherRange_m < range_m;
    if (nearer || (otherRange_m == range_m && otherObject < object))
      *this = {otherRange_m, otherObject};
  }
};

/** The interface of everything that a simulated robot can drive in. */
class Surroundings
{
 public:
  virtual ~Surroundings() = default;

  /** The nearest object along a ray.
   *  @param direction unit vector
   *  @param time_s time since the start, for surroundings with moving objects */
  virtual Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                   double maxRange_m, double time_s) const = 0;

  /** Distance from a point to the nearest object, or limit_m if that is smaller. */
  virtual double clearance_m(const Eigen::Vector2d& point_m, double limit_m,
                             double time_s) const = 0;
};
}  // namespace psmks
