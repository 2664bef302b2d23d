/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/JointProblem.h>

namespace psmks
{
/** Gauss-Newton's normal equations H step = g at a pose, for a step in (x, y, phi), reference axes.
 */
struct NormalEquations
{
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();  //!< J' W J, the information about the pose
  Eigen::Vector3d g = Eigen::Vector3d::Zero();  //!< -J' W e, the gradient of the log likelihood
};

/** Normal equations of a problem at a pose, with the kernel's weights there.
 *  @param withPrior whether the prior is included */
NormalEquations linearise(const JointProblem& problem, const Pose2& T_ref_cur,
                          bool withPrior = true);

/** Residual e of a term at a pose and its derivative J by (x, y, phi); JointProblem.h states the
 * formulas. */
struct LinePairResidual
{
  Eigen::Vector2d e;
  Eigen::Matrix<double, 2, 3> J;
};
LinePairResidual residual(const LinePairTerm& term, const Pose2& T_ref_cur);

struct CirclePairResidual
{
  Eigen::Vector2d e;
  Eigen::Matrix<double, 2, 3> J;
};
CirclePairResidual residual(const CirclePairTerm& term, const Pose2& T_ref_cur);

struct RayResidual
{
  double e;
  Eigen::RowVector3d J;
};
RayResidual residual(const RayTerm& term, const Pose2& T_ref_cur);

struct SolverLimits
{
  int maxIterations;
  double stopTranslation_m, stopRotation_rad;
};

struct JointSolution
{
  int iterations = 0;
  bool converged = false;
};

/** Minimises the cost of a problem by Gauss-Newton, with the kernel's weights renewed at every step
 * (iteratively reweighted least squares). Along a direction without information the pose stays.
 *  @param[in,out] T_ref_cur start and result; the last pose where the iterations run out */
JointSolution solveByGaussNewton(const JointProblem& problem, const SolverLimits& limits,
                                 Pose2& T_ref_cur);
}  // namespace psmks
