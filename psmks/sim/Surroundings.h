/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** What a ray met. */
struct Hit
{
  static constexpr int kNothing = -1;  //!< no object within the range
  double range_m = 0;                  //!< the range asked for where nothing was met
  int object = kNothing;               //!< see World::Object; any number >= 0 elsewhere

  /** Takes over what else the ray meets where that is nearer; of two things at one range the one
   * with the lower number counts, in whatever order they come. */
  void take(double otherRange_m, int otherObject)
  {
    const bool nearer = otherRange_m < range_m;
    if (nearer || (otherRange_m == range_m && otherObject < object))
      *this = {otherRange_m, otherObject};
  }
};

/** What a simulated robot finds around itself: the interface of everything one can drive in. */
class Surroundings
{
 public:
  virtual ~Surroundings() = default;

  /** The nearest thing along a ray.
   *  @param direction unit vector
   *  @param time_s since the start, where things move */
  virtual Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                   double maxRange_m, double time_s) const = 0;

  /** Distance from a point to the nearest thing, but limit_m where that is farther. */
  virtual double clearance_m(const Eigen::Vector2d& point_m, double limit_m,
                             double time_s) const = 0;
};
}  // namespace psmks
