/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Disc.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** A disc that walks along a path, there and back again for ever, at a constant speed: a person. */
struct MovingObject
{
  double radius_m = 0.2;
  double speed_mps = 0.8;
  std::vector<Eigen::Vector2d> path_m;  //!< at least one point

  /** Where its centre is. */
  Eigen::Vector2d place_m(double time_s) const;

  Disc disc(double time_s) const { return {place_m(time_s), radius_m}; }
};
}  // namespace psmks
