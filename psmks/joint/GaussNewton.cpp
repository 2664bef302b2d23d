/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/GaussNewton.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace psmks
{
namespace
{
/** Rotation and its derivative, computed once per pose. */
struct Motion
{
  explicit Motion(const Pose2& T)
      : R(T.rotation()), dR(T.rotationDerivative()), t(T.translation()), phi_rad(T.phi_rad)
  {
  }
  Eigen::Matrix2d R, dR;
  Eigen::Vector2d t;
  double phi_rad;
};

LinePairResidual residualAt(const LinePairTerm& term, const Motion& T)
{
  LinePairResidual r;
  r.e << term.refNormal.dot(T.R * term.curAnchor_m + T.t) - term.refDistance_m,
      wrapAngle(term.angle_rad + T.phi_rad);
  r.J << term.refNormal.x(), term.refNormal.y(), term.refNormal.dot(T.dR * term.curAnchor_m),  //
      0, 0, 1;
  return r;
}

CirclePairResidual residualAt(const CirclePairTerm& term, const Motion& T)
{
  CirclePairResidual r;
  r.e = T.R * term.curCentre_m + T.t - term.refCentre_m;
  r.J << Eigen::Matrix2d::Identity(), T.dR * term.curCentre_m;
  return r;
}

RayResidual residualAt(const RayTerm& term, const Motion& T)
{
  if (term.pointIsCurrent)
  {
    const Eigen::Vector2d& n = term.normal;
    return {n.dot(T.R * term.point_m + T.t) - term.distance_m,
            {n.x(), n.y(), n.dot(T.dR * term.point_m)}};
  }
  const Eigen::Vector2d n = T.R * term.normal;
  const Eigen::Vector2d fromOrigin_m = term.point_m - T.t;
  return {n.dot(fromOrigin_m) - term.distance_m,
          {-n.x(), -n.y(), (T.dR * term.normal).dot(fromOrigin_m)}};
}

/** Cauchy: rho(s) = k^2 log(1 + s / k^2), weight rho'(s) = 1 / (1 + s / k^2). */
struct Kernel
{
  explicit Kernel(double width) : inverse_k2(1 / (width * width)) {}
  double weight(double s) const { return 1 / (1 + s * inverse_k2); }
  double inverse_k2;
};

/** Adds a pair, whose residual has two parts. */
template <class Residual>
void addPair(const Residual& r, const Eigen::Matrix2d& information, const Kernel& kernel,
             NormalEquations& n)
{
  const double s = r.e.dot(information * r.e);
  const Eigen::Matrix2d W = kernel.weight(s) * information;
  const Eigen::Matrix<double, 3, 2> JtW = r.J.transpose() * W;
  n.H += JtW * r.J;
  n.g -= JtW * r.e;
}

void addPrior(const PriorTerm& prior, const Pose2& T, NormalEquations& n)
{
  const Eigen::Vector3d e(T.x_m - prior.T_ref_cur.x_m, T.y_m - prior.T_ref_cur.y_m,
                          wrapAngle(T.phi_rad - prior.T_ref_cur.phi_rad));
  n.H += prior.information;
  n.g -= prior.information * e;
}

/** The step that solves H step = g; along directions without information the step is zero. */
Eigen::Vector3d solveStep(const NormalEquations& n)
{
  // A standard deviation of 100 m and 10 rad: no influence where anything is known.
  const Eigen::Vector3d nextToNothing(1e-4, 1e-4, 1e-2);
  Eigen::Matrix3d H = n.H;
  H.diagonal() += nextToNothing;
  return H.ldlt().solve(n.g);
}
}  // namespace

LinePairResidual residual(const LinePairTerm& term, const Pose2& T_ref_cur)
{
  return residualAt(term, Motion(T_ref_cur));
}

CirclePairResidual residual(const CirclePairTerm& term, const Pose2& T_ref_cur)
{
  return residualAt(term, Motion(T_ref_cur));
}

RayResidual residual(const RayTerm& term, const Pose2& T_ref_cur)
{
  return residualAt(term, Motion(T_ref_cur));
}

NormalEquations linearise(const JointProblem& problem, const Pose2& T_ref_cur, bool withPrior)
{
  const Motion T(T_ref_cur);
  const Kernel kernel(problem.kernelWidth);
  NormalEquations n;
  for (const LinePairTerm& term : problem.linePairs)
    addPair(residualAt(term, T), term.information, kernel, n);
  for (const CirclePairTerm& term : problem.circlePairs)
    addPair(residualAt(term, T), term.information, kernel, n);
  for (const RayTerm& term : problem.rays)
  {
    const RayResidual r = residualAt(term, T);
    const double s = r.e * r.e * term.information;
    const double w = kernel.weight(s) * term.information;
    n.H += w * r.J.transpose() * r.J;
    n.g -= w * r.e * r.J.transpose();
  }
  if (withPrior && problem.prior) addPrior(*problem.prior, T_ref_cur, n);
  return n;
}

JointSolution solveByGaussNewton(const JointProblem& problem, const SolverLimits& limits,
                                 Pose2& T_ref_cur)
{
  JointSolution solution;
  while (solution.iterations < limits.maxIterations && !solution.converged)
  {
    const Eigen::Vector3d step = solveStep(linearise(problem, T_ref_cur));
    T_ref_cur = {T_ref_cur.x_m + step.x(), T_ref_cur.y_m + step.y(),
                 wrapAngle(T_ref_cur.phi_rad + step.z())};
    ++solution.iterations;
    solution.converged = step.head<2>().norm() < limits.stopTranslation_m &&
                         std::abs(step.z()) < limits.stopRotation_rad;
  }
  return solution;
}
}  // namespace psmks
