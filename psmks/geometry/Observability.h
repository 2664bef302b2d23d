/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** What an information matrix of (x, y, phi) fixes. */
struct Observability
{
  Eigen::Vector2d weakDirection =
      Eigen::Vector2d::UnitX();  //!< in which the position is known worst
  double weakSigma_m = 0;  //!< its standard deviation there, heading estimated too; may be infinite
  double headingSigma_rad = 0;  //!< of the heading, position estimated too; may be infinite
};

/** From the smaller eigenvalue of the Schur complement of the heading, and the Schur complement of
 * the position (docs/algorithm.md, degeneracy). */
Observability observability(const Eigen::Matrix3d& information);
}  // namespace psmks
