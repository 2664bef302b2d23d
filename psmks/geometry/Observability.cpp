/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Observability.h>

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
}  // namespace psmks
