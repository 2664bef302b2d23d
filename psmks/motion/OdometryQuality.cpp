/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/motion/OdometryQuality.h>

#include <Eigen/Cholesky>
#include <algorithm>

namespace psmks
{
void OdometryQuality::learn(const UncertainPose& measured, const Pose2& matched)
{
  /** Most that an error counts: it may be that of the match. Unit: variances. Evidence: 99.7 % of
   * normal errors are smaller. */
  constexpr double kMost = 9;
  const Eigen::Vector3d error(matched.x_m - measured.pose.x_m, matched.y_m - measured.pose.y_m,
                              wrapAngle(matched.phi_rad - measured.pose.phi_rad));
  const double square =
      error.dot(measured.covariance.llt().solve(error)) / static_cast<double>(error.size());
  sum_ += std::min(square, kMost);
  ++count_;
}

double OdometryQuality::varianceFactor() const
{
  /** As many motions the statement of the options counts. Unit: motions. Definition: few enough to
   * be outweighed within seconds, and enough that the first ones prove nothing. */
  constexpr double kPrior = 10;
  return std::min(1.0, (sum_ + kPrior) / (count_ + kPrior));
}
}  // namespace psmks
