/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/ChiSquared.h>
#include <psmks/geometry/Innovation.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace psmks
{
bool Innovation::isAgreement() const
{
  return degreesOfFreedom > 0 && chi2 <= chi2At95(degreesOfFreedom);
}

bool Innovation::isContradiction() const
{
  return degreesOfFreedom > 0 && chi2 > chi2At999(degreesOfFreedom);
}

Innovation innovation(const UncertainPose& guess, const Pose2& T_ref_cur,
                      const Eigen::Matrix3d& information, const Eigen::Vector3d& gradient)
{
  // In coordinates z = L^-1 (x - x_guess) with P_guess = L L' the guess is standard normal, and in
  // the axes of the eigenvectors of the scans' information there the measurements part by axis: nu
  // is one number for each, and its variance 1 + 1 / eigenvalue.

  /** Share of the largest eigenvalue below which another one is no information. Unit: share.
   * Definition: the rounding of the doubles from which they are computed. */
  constexpr double kRounding = 1e-9;
  const Eigen::Matrix3d L = guess.covariance.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(L.transpose() * information * L);
  const Eigen::Vector3d fromGuess(T_ref_cur.x_m - guess.pose.x_m, T_ref_cur.y_m - guess.pose.y_m,
                                  wrapAngle(T_ref_cur.phi_rad - guess.pose.phi_rad));
  const Eigen::Matrix3d Vt = axes.eigenvectors().transpose();
  const Eigen::Vector3d z = Vt * L.triangularView<Eigen::Lower>().solve(fromGuess);
  const Eigen::Vector3d pull = Vt * (L.transpose() * gradient);

  Innovation result;
  for (int i = 0; i < 3; ++i)
  {
    const double known = axes.eigenvalues()[i];
    if (!(known > kRounding * axes.eigenvalues()[2])) continue;
    const double nu = z[i] + pull[i] / known;
    result.chi2 += nu * nu / (1 + 1 / known);
    ++result.degreesOfFreedom;
  }
  return result;
}
}  // namespace psmks
