/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <ceres/ceres.h>
#include <psmks/ceres/CeresSolvers.h>
#include <psmks/match/JointProblem.h>
#include <psmks/paper/TranslationRegression.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace psmks
{
namespace
{
template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;

/** Pose parameters: x, y, phi. */
template <class T>
Vector2<T> rotated(const T* pose, const Eigen::Vector2d& p)
{
  using std::cos;
  using std::sin;
  const T c = cos(pose[2]), s = sin(pose[2]);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

template <class T>
T wrapped(const T& angle_rad)
{
  using std::floor;
  return angle_rad - 2 * kPi * floor((angle_rad + kPi) / (2 * kPi));
}

/** The factor L' of the information L L': |L' e|^2 is then the squared Mahalanobis distance of e.
 */
template <int N>
Eigen::Matrix<double, N, N> rootOf(const Eigen::Matrix<double, N, N>& information)
{
  return information.llt().matrixU();
}

/** sqrt(w) (e + slope.s) */
class TranslationCost : public ceres::SizedCostFunction<1, 2>
{
 public:
  explicit TranslationCost(const TranslationTerm& term) : term_(term), root_(std::sqrt(term.weight))
  {
  }

  bool Evaluate(const double* const* step, double* residual, double** jacobians) const override
  {
    residual[0] =
        root_ * (term_.residual_m + term_.slope.x() * step[0][0] + term_.slope.y() * step[0][1]);
    if (!jacobians || !jacobians[0]) return true;
    jacobians[0][0] = root_ * term_.slope.x();
    jacobians[0][1] = root_ * term_.slope.y();
    return true;
  }

 private:
  const TranslationTerm& term_;
  double root_;
};

struct LinePairCost
{
  explicit LinePairCost(const LinePairTerm& t) : term(t), root(rootOf<2>(t.information)) {}

  template <class T>
  bool operator()(const T* pose, T* residual) const
  {
    const Vector2<T> turned = rotated(pose, term.curAnchor_m);
    const T distance = term.refNormal.x() * (turned.x() + pose[0]) +
                       term.refNormal.y() * (turned.y() + pose[1]) - term.refDistance_m;
    const T angle = wrapped(T(pose[2] + term.angle_rad));
    residual[0] = root(0, 0) * distance + root(0, 1) * angle;
    residual[1] = root(1, 1) * angle;
    return true;
  }

  const LinePairTerm& term;
  Eigen::Matrix2d root;
};

struct CirclePairCost
{
  explicit CirclePairCost(const CirclePairTerm& t) : term(t), root(rootOf<2>(t.information)) {}

  template <class T>
  bool operator()(const T* pose, T* residual) const
  {
    const Vector2<T> turned = rotated(pose, term.curCentre_m);
    const T x = turned.x() + pose[0] - term.refCentre_m.x();
    const T y = turned.y() + pose[1] - term.refCentre_m.y();
    residual[0] = root(0, 0) * x + root(0, 1) * y;
    residual[1] = root(1, 1) * y;
    return true;
  }

  const CirclePairTerm& term;
  Eigen::Matrix2d root;
};

struct RayCost
{
  explicit RayCost(const RayTerm& t) : term(t), root(std::sqrt(t.information)) {}

  template <class T>
  bool operator()(const T* pose, T* residual) const
  {
    const Vector2<T> turned = rotated(pose, term.pointIsCurrent ? term.point_m : term.normal);
    const T distance =
        term.pointIsCurrent
            ? term.normal.x() * (turned.x() + pose[0]) + term.normal.y() * (turned.y() + pose[1])
            : turned.x() * (term.point_m.x() - pose[0]) + turned.y() * (term.point_m.y() - pose[1]);
    residual[0] = root * (distance - term.distance_m);
    return true;
  }

  const RayTerm& term;
  double root;
};

struct PriorCost
{
  explicit PriorCost(const PriorTerm& t) : term(t), root(rootOf<3>(t.information)) {}

  template <class T>
  bool operator()(const T* pose, T* residual) const
  {
    Eigen::Matrix<T, 3, 1> e(pose[0] - term.T_ref_cur.x_m, pose[1] - term.T_ref_cur.y_m,
                             wrapped(T(pose[2] - term.T_ref_cur.phi_rad)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>>{residual} = root.cast<T>() * e;
    return true;
  }

  const PriorTerm& term;
  Eigen::Matrix3d root;
};

/** Solves until the cost stops changing in its last digits, so that a comparison of solvers does
 * not show differences of their stopping rules. */
bool solve(ceres::Problem& problem)
{
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 1e-12;
  options.parameter_tolerance = 1e-12;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable();
}

/** Options by which several terms may share a loss function: the problem does not own it. */
ceres::Problem::Options sharedLoss()
{
  ceres::Problem::Options options;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

class CeresSolvers : public ExternalSolvers
{
 public:
  bool solveTranslation(const TranslationProblem& terms, Eigen::Vector2d& step_m) const override
  {
    if (terms.terms.empty()) return false;
    Eigen::Vector2d step = step_m;
    ceres::Problem problem;
    for (const TranslationTerm& term : terms.terms)
      problem.AddResidualBlock(new TranslationCost(term), nullptr, step.data());
    if (!solve(problem)) return false;
    step_m = step;
    return true;
  }

  bool solveJoint(const JointProblem& terms, Pose2& T_ref_cur) const override
  {
    if (terms.linePairs.empty() && terms.circlePairs.empty() && terms.rays.empty() && !terms.prior)
      return false;
    double pose[3] = {T_ref_cur.x_m, T_ref_cur.y_m, T_ref_cur.phi_rad};
    ceres::CauchyLoss kernel(terms.kernelWidth);
    ceres::Problem problem(sharedLoss());
    for (const LinePairTerm& term : terms.linePairs)
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<LinePairCost, 2, 3>(new LinePairCost(term)), &kernel,
          pose);
    for (const CirclePairTerm& term : terms.circlePairs)
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<CirclePairCost, 2, 3>(new CirclePairCost(term)), &kernel,
          pose);
    for (const RayTerm& term : terms.rays)
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<RayCost, 1, 3>(new RayCost(term)),
                               &kernel, pose);
    if (terms.prior)
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<PriorCost, 3, 3>(new PriorCost(*terms.prior)), nullptr,
          pose);
    if (!solve(problem)) return false;
    T_ref_cur = {pose[0], pose[1], wrapAngle(pose[2])};
    return true;
  }
};
}  // namespace

std::shared_ptr<const ExternalSolvers> makeCeresSolvers()
{
  return std::make_shared<CeresSolvers>();
}
}  // namespace psmks
