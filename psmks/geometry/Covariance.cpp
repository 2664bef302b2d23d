/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Covariance.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace psmks
{
namespace
{
/** Scales the axes of which the variance is above kVaguest, and keeps the correlations. */
Eigen::Matrix3d withCappedVariances(Eigen::Matrix3d covariance)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!(covariance(i, i) > kVaguest)) continue;
    const double scale = std::sqrt(kVaguest) / std::sqrt(covariance(i, i));
    covariance.row(i) *= scale;
    covariance.col(i) *= scale;
    covariance(i, i) = kVaguest;
  }
  return covariance;
}
}  // namespace

bool isCovariance(const Eigen::Matrix3d& matrix)
{
  /** Share of the largest element by which a covariance may be asymmetric. Unit: share. Definition:
   * the rounding of the doubles from which both halves are computed. */
  constexpr double kRounding = 1e-9;
  const double asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff();
  return matrix.allFinite() && asymmetry <= kRounding * matrix.cwiseAbs().maxCoeff() &&
         matrix.llt().info() == Eigen::Success;
}

Eigen::Matrix3d boundedCovariance(const Eigen::Matrix3d& covariance)
{
  /** Least share of the largest eigenvalue that another one has. Unit: share. Definition: fifty
   * times the rounding of a double. */
  constexpr double kLeastShare = 1e-14;
  Eigen::Matrix3d bounded =
      withCappedVariances(covariance.selfadjointView<Eigen::Lower>().toDenseMatrix());
  if (bounded.isZero(0)) return bounded;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(bounded);
  const double largest = std::min(axes.eigenvalues()[2], kVaguest);
  const double least = std::max(kLeastShare * largest, kSharpest);
  if (axes.eigenvalues()[0] >= least && axes.eigenvalues()[2] <= kVaguest) return bounded;
  const Eigen::Vector3d variances = axes.eigenvalues().cwiseMax(least).cwiseMin(kVaguest);
  bounded = axes.eigenvectors() * variances.asDiagonal() * axes.eigenvectors().transpose();
  return bounded.selfadjointView<Eigen::Lower>();
}
}  // namespace psmks
