/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>

namespace psmks::test
{
/** Two fixed mountings of sensors, of no symmetry. */
const Pose2 kRef{0.78, 0.10, degToRad(30)}, kCur{-0.20, 0.40, degToRad(-100)};

/** A motion whose covariance couples all three components. */
inline UncertainPose someMotion()
{
  Eigen::Matrix3d covariance;
  covariance << 4e-4, 1e-4, 2e-5,  //
      1e-4, 9e-4, -3e-5,           //
      2e-5, -3e-5, 1e-4;
  return {{0.5, -0.2, degToRad(25)}, covariance};
}
}  // namespace psmks::test
