/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>

#include <Eigen/Core>

namespace psmks
{
/** How far two independent measurements of a pose are apart: a guess with a covariance, and what
 * the scans alone say.
 *
 * The innovation is nu = x_scans - x_guess, its covariance S = P_guess + P_scans, and
 * chi2 = nu' S^-1 nu. Directions of (x, y, phi) in which the scans say nothing do not count: they
 * lower the degrees of freedom. Of measurements whose covariances are right, one in twenty has a
 * chi2 above that of 95 %, one in a thousand one above that of 99.9 %. */
struct Innovation
{
  double chi2 = 0;
  int degreesOfFreedom = 0;  //!< 0 to 3: directions in which the scans fix the pose

  /** Whether chi2 is at most the 95 % quantile, in at least one degree of freedom. */
  bool isAgreement() const;

  /** Whether chi2 is above the 99.9 % quantile. */
  bool isContradiction() const;
};

/** The innovation of a guess where the estimate may already have been pulled by it.
 *
 *  The scans' cost is taken as quadratic about the estimate, so that they alone say
 *  x_scans = T_ref_cur + information^-1 gradient.
 *  @param guess its covariance is positive definite
 *  @param T_ref_cur any pose near the scans' optimum
 *  @param information of the scans alone about (x, y, phi), positive semidefinite
 *  @param gradient of the scans' log likelihood at T_ref_cur; 0 at their optimum */
Innovation innovation(const UncertainPose& guess, const Pose2& T_ref_cur,
                      const Eigen::Matrix3d& information, const Eigen::Vector3d& gradient);
}  // namespace psmks
