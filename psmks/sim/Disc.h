/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
/** A round object of the plane. */
struct Disc
{
  Eigen::Vector2d centre_m;
  double radius_m;

  /** The range at which a ray meets the outline, or infinity if it does not.
   *  @param direction unit vector */
  double rangeAlong_m(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction) const
  {
    const Eigen::Vector2d toCentre = centre_m - origin_m;
    const double across_m = direction.x() * toCentre.y() - direction.y() * toCentre.x();
    if (std::abs(across_m) >= radius_m) return std::numeric_limits<double>::infinity();
    const double halfChord_m = std::sqrt(radius_m * radius_m - across_m * across_m);
    const double along_m = direction.dot(toCentre);
    if (along_m > halfChord_m) return along_m - halfChord_m;
    const double leaving_m = along_m + halfChord_m;
    return leaving_m > 0 ? leaving_m : std::numeric_limits<double>::infinity();
  }

  /** Distance from a point to the disc; 0 inside. */
  double distance_m(const Eigen::Vector2d& point_m) const
  {
    return std::max(0.0, (centre_m - point_m).norm() - radius_m);
  }
};
}  // namespace psmks
