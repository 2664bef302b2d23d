/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Disc.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** A disc that moves along a path at a constant speed, to its end and back again without end. It
 * stands for a person. */
struct MovingObject
{
  double radius_m = 0.2;
  double speed_mps = 0.8;
  std::vector<Eigen::Vector2d> path_m;  //!< at least one point

  /** The place of its centre at a time. */
  Eigen::Vector2d place_m(double time_s) const;

  Disc disc(double time_s) const { return {place_m(time_s), radius_m}; }
};
}  // namespace psmks
