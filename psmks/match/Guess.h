/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <optional>

namespace psmks
{
/** Where a match starts. */
struct Guess
{
  Pose2 T_ref_cur;

  /** Covariance of (x, y, phi) in reference axes, positive definite. Given, the guess is a
   * measurement that enters every normal equation of the joint scheme, unless it leaves nothing
   * acceptable and is given up; absent, it is a starting
   * point and nothing more. */
  std::optional<Eigen::Matrix3d> covariance;
};
}  // namespace psmks
