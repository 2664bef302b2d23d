/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PairError.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace psmks
{
PairError pairError(const Pose2& T_ref_cur, const Pose2& T_ref_cur_true)
{
  return {(T_ref_cur.translation() - T_ref_cur_true.translation()).norm(),
          std::abs(wrapAngle(T_ref_cur.phi_rad - T_ref_cur_true.phi_rad))};
}

bool isSuccess(const PairError& error, const PairError& limit)
{
  return error.translation_m < limit.translation_m && !(error.rotation_rad >= limit.rotation_rad);
}

bool isAcceptedAndWrong(MatchStatus status, const PairError& error, const PairError& limit)
{
  const bool accepted = status == MatchStatus::Converged || status == MatchStatus::MaxIterations;
  return accepted && (error.translation_m > kWrongFactor * limit.translation_m ||
                      error.rotation_rad > kWrongFactor * limit.rotation_rad);
}

double nees(const Pose2& T_ref_cur, const Eigen::Matrix3d& covariance, const Pose2& T_ref_cur_true)
{
  const Eigen::Vector3d error(T_ref_cur.x_m - T_ref_cur_true.x_m,
                              T_ref_cur.y_m - T_ref_cur_true.y_m,
                              wrapAngle(T_ref_cur.phi_rad - T_ref_cur_true.phi_rad));
  const Eigen::LLT<Eigen::Matrix3d> cholesky(covariance);
  if (cholesky.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  return error.dot(cholesky.solve(error));
}
}  // namespace psmks
