/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** How well an information matrix of (x, y, phi) constrains the position and the heading. */
struct Observability
{
  /** Unit vector along which the position is least certain. */
  Eigen::Vector2d weakDirection = Eigen::Vector2d::UnitX();
  /** Standard deviation along it if the heading is estimated too; may be infinite. */
  double weakSigma_m = 0;
  /** Standard deviation of the heading if the position is estimated too; may be infinite. */
  double headingSigma_rad = 0;
};

/** Finds the weak direction and its standard deviation from the smaller eigenvalue of the Schur
 * complement of the heading, and the standard deviation of the heading from the Schur complement of
 * the position (docs/derivations.md, "Degeneracy").
 *  @param information symmetric and positive semi-definite, of (x, y, phi) in 1/m^2, 1/(m rad),
 *      1/rad^2 */
Observability observability(const Eigen::Matrix3d& information);
}  // namespace psmks
