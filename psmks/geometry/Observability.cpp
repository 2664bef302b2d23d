/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Observability.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
double sigmaOf(double information)
{
  return information > 0 ? 1 / std::sqrt(information) : std::numeric_limits<double>::infinity();
}

/** The smaller eigenvalue of a symmetric 2x2 matrix.
 *  @param[out] direction its unit eigenvector */
double smallerEigenvalue(const Eigen::Matrix2d& S, Eigen::Vector2d& direction)
{
  const double mean = 0.5 * (S(0, 0) + S(1, 1)), difference = 0.5 * (S(0, 0) - S(1, 1));
  const double radius = std::hypot(difference, S(0, 1));
  // The eigenvector of the larger eigenvalue lies at half the angle of (difference of the diagonal,
  // off-diagonal).
  const double larger_rad = 0.5 * std::atan2(S(0, 1), difference);
  direction = {-std::sin(larger_rad), std::cos(larger_rad)};
  return mean - radius;
}

/** The information of the heading that estimating the position takes away: coupling' position^-1
 * coupling. A direction in which the position is not constrained at all, such as that along a
 * single wall, takes nothing away; what rounding has left there is ignored. */
double explainedByPosition(const Eigen::Matrix2d& position, const Eigen::Vector2d& coupling)
{
  /** Share of the larger eigenvalue below which the smaller one is 0. Unit: share. Definition: the
   * rounding of the doubles from which both are computed. */
  constexpr double kRounding = 1e-9;
  Eigen::Vector2d weak;
  const double smaller = smallerEigenvalue(position, weak);
  const double larger = position.trace() - smaller;
  const double alongStrong = Eigen::Vector2d(weak.y(), -weak.x()).dot(coupling);
  const double alongWeak = weak.dot(coupling);
  double explained = larger > 0 ? alongStrong * alongStrong / larger : 0;
  if (smaller > kRounding * larger) explained += alongWeak * alongWeak / smaller;
  return explained;
}
}  // namespace

Observability observability(const Eigen::Matrix3d& H)
{
  Observability o;
  const Eigen::Matrix2d position = H.topLeftCorner<2, 2>();
  const Eigen::Vector2d coupling = H.topRightCorner<2, 1>();
  Eigen::Matrix2d schur = position;
  if (H(2, 2) > 0) schur -= coupling * coupling.transpose() / H(2, 2);
  o.weakSigma_m = sigmaOf(smallerEigenvalue(schur, o.weakDirection));
  o.headingSigma_rad = sigmaOf(H(2, 2) - explainedByPosition(position, coupling));
  return o;
}

Observability observabilityAtHeading(const Eigen::Matrix3d& information)
{
  Eigen::Matrix3d position = Eigen::Matrix3d::Identity();
  position.topLeftCorner<2, 2>() = information.topLeftCorner<2, 2>();
  return observability(position);
}

Eigen::Vector2d positionPerHeading(const Eigen::Matrix3d& information, double weakestSigma_m)
{
  /** Share of the larger eigenvalue below which the smaller one is no information. Unit: share.
   * Definition: the rounding of the doubles from which both are computed. */
  constexpr double kRounding = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> position(information.topLeftCorner<2, 2>());
  Eigen::Vector2d perHeading = Eigen::Vector2d::Zero();
  for (int i = 0; i < 2; ++i)
  {
    const double known = position.eigenvalues()[i];
    if (!(known > kRounding * position.eigenvalues()[1])) continue;
    if (known * weakestSigma_m * weakestSigma_m < 1) continue;
    const Eigen::Vector2d axis = position.eigenvectors().col(i);
    perHeading -= axis * (axis.dot(information.topRightCorner<2, 1>()) / known);
  }
  return perHeading;
}

Pose2 turnedTo(double phi_rad, const Pose2& T_ref_cur, const Eigen::Matrix3d& information,
               double weakestSigma_m)
{
  // A turn about the pivot moves the position by J (t - pivot) per radian, J a quarter turn.
  const Eigen::Vector2d perHeading = positionPerHeading(information, weakestSigma_m);
  const Eigen::Vector2d fromPivot_m(perHeading.y(), -perHeading.x());
  const Eigen::Vector2d pivot_m = T_ref_cur.translation() - fromPivot_m;
  const Pose2 turn{0, 0, wrapAngle(phi_rad - T_ref_cur.phi_rad)};
  const Eigen::Vector2d t_m = pivot_m + turn.rotation() * fromPivot_m;
  return {t_m.x(), t_m.y(), phi_rad};
}
}  // namespace psmks
