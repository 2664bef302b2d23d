/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/JointProblem.h>

namespace psmks
{
/** J'WJ and -J'We at a pose; order x, y, phi. */
struct NormalEquations
{
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
};

/** @param withPrior whether the prior enters */
NormalEquations linearise(const JointProblem& problem, const Pose2& T_ref_cur,
                          bool withPrior = true);

/** Residual and its derivative by (x, y, phi); the formulas stand with the terms. */
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

/** Gauss-Newton with the kernel's weights renewed at every step (iteratively reweighted least
 * squares). A direction without information is not stepped along. */
JointSolution solveByGaussNewton(const JointProblem& problem, const SolverLimits& limits,
                                 Pose2& T_ref_cur);
}  // namespace psmks
