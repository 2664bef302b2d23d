/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/ceres/CeresSolvers.h>
#include <psmks/match/JointProblem.h>
#include <psmks/paper/TranslationRegression.h>
#include <tests/support/PoseMatcher.h>

#include <Eigen/LU>
#include <random>

namespace psmks
{
namespace
{
class CeresSolversTest : public testing::TestWithParam<unsigned>
{
 protected:
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(rng_);
  }

  Eigen::Vector2d point() { return {between(-5, 5), between(-5, 5)}; }

  Eigen::Vector2d unit()
  {
    const double angle_rad = between(-kPi, kPi);
    return {std::cos(angle_rad), std::sin(angle_rad)};
  }

  template <int N>
  Eigen::Matrix<double, N, N> information(double scale)
  {
    Eigen::Matrix<double, N, N> root;
    for (int i = 0; i < N * N; ++i) root(i / N, i % N) = between(-1, 1);
    return scale * (root * root.transpose() + Eigen::Matrix<double, N, N>::Identity());
  }

  /** Terms that agree with `truth` up to a little noise, and one outlier of each kind. */
  JointProblem jointProblem(const Pose2& truth)
  {
    JointProblem problem;
    const double outlier_m = 0.5;
    for (int i = 0; i < 8; ++i) problem.linePairs.push_back(linePair(truth, i ? 0 : outlier_m));
    for (int i = 0; i < 6; ++i) problem.circlePairs.push_back(circlePair(truth, i ? 0 : outlier_m));
    for (int i = 0; i < 12; ++i) problem.rays.push_back(ray(truth, i % 2 == 0, i ? 0 : outlier_m));
    return problem;
  }

  LinePairTerm linePair(const Pose2& truth, double off_m)
  {
    const Eigen::Vector2d n = unit(), q = point();
    const double d = n.dot(truth * q) + off_m + between(-0.01, 0.01);
    return {n, d, q, wrapAngle(-truth.phi_rad + between(-0.005, 0.005)), information<2>(1e4)};
  }

  CirclePairTerm circlePair(const Pose2& truth, double off_m)
  {
    const Eigen::Vector2d q = point();
    const Eigen::Vector2d noise_m(between(-0.01, 0.01), between(-0.01, 0.01));
    return {truth * q + off_m * unit() + noise_m, q, information<2>(1e4)};
  }

  RayTerm ray(const Pose2& truth, bool pointIsCurrent, double off_m)
  {
    const Eigen::Vector2d n = unit(), p = point();
    const double d =
        pointIsCurrent ? n.dot(truth * p) : (truth.rotation() * n).dot(p - truth.translation());
    return {pointIsCurrent, p, n, d + off_m + between(-0.02, 0.02), 2500};
  }

  std::mt19937 rng_{GetParam()};
  std::shared_ptr<const ExternalSolvers> solvers_ = makeCeresSolvers();
};

// ---- the cost of JointProblem.h, written down once more from its words
// ----------------------------

double kernel(double s, double k) { return k * k * std::log(1 + s / (k * k)); }

double costOf(const JointProblem& problem, const Pose2& pose)
{
  double cost = 0;
  for (const LinePairTerm& t : problem.linePairs)
  {
    const Eigen::Vector2d e(t.refNormal.dot(pose * t.curAnchor_m) - t.refDistance_m,
                            wrapAngle(t.angle_rad + pose.phi_rad));
    cost += kernel(e.dot(t.information * e), problem.kernelWidth) / 2;
  }
  for (const CirclePairTerm& t : problem.circlePairs)
  {
    const Eigen::Vector2d e = pose * t.curCentre_m - t.refCentre_m;
    cost += kernel(e.dot(t.information * e), problem.kernelWidth) / 2;
  }
  for (const RayTerm& t : problem.rays)
  {
    const double e =
        (t.pointIsCurrent ? t.normal.dot(pose * t.point_m)
                          : (pose.rotation() * t.normal).dot(t.point_m - pose.translation())) -
        t.distance_m;
    cost += kernel(e * e * t.information, problem.kernelWidth) / 2;
  }
  if (!problem.prior) return cost;
  const Pose2& p = problem.prior->T_ref_cur;
  const Eigen::Vector3d e(pose.x_m - p.x_m, pose.y_m - p.y_m, wrapAngle(pose.phi_rad - p.phi_rad));
  return cost + e.dot(problem.prior->information * e) / 2;
}

/** The Newton step from a pose by the numeric gradient and Hessian of the cost: the distance of the
 * pose from the minimum in metres and radians. */
Eigen::Vector3d remainingStep(const JointProblem& problem, const Pose2& pose)
{
  constexpr double h = 1e-4;
  const auto at = [&](const Eigen::Vector3d& d) {
    return costOf(problem, {pose.x_m + d[0], pose.y_m + d[1], pose.phi_rad + d[2]});
  };
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d a = h * Eigen::Vector3d::Unit(i);
    gradient[i] = (at(a) - at(-a)) / (2 * h);
    for (int j = 0; j < 3; ++j)
    {
      const Eigen::Vector3d b = h * Eigen::Vector3d::Unit(j);
      hessian(i, j) = (at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4 * h * h);
    }
  }
  return hessian.inverse() * gradient;
}

TEST_P(CeresSolversTest, TranslationEqualsTheClosedForm)
{
  TranslationProblem problem;
  for (int i = 0; i < 60; ++i)
    problem.terms.push_back({between(-0.1, 0.1), -unit() / between(0.2, 1), between(1e3, 1e6)});

  Eigen::Vector2d step_m = Eigen::Vector2d::Zero();
  ASSERT_TRUE(solvers_->solveTranslation(problem, step_m));
  EXPECT_LT((step_m - solveTranslation(problem)).norm(), 1e-4) << "seed " << GetParam();
}

TEST_P(CeresSolversTest, JointSolutionIsTheMinimumOfTheDocumentedCost)
{
  const Pose2 truth{between(-1, 1), between(-1, 1), between(-kPi, kPi)};
  const JointProblem problem = jointProblem(truth);
  Pose2 solution{truth.x_m + 0.03, truth.y_m - 0.02, wrapAngle(truth.phi_rad + 0.01)};
  ASSERT_TRUE(solvers_->solveJoint(problem, solution));

  const Eigen::Vector3d remaining = remainingStep(problem, solution);
  EXPECT_LT(remaining.head<2>().norm(), 1e-6) << "seed " << GetParam();
  EXPECT_LT(std::abs(remaining[2]), 1e-6) << "seed " << GetParam();
  EXPECT_TRUE(isNearly(solution, truth, 0.03, degToRad(0.5))) << "seed " << GetParam();
}

TEST_P(CeresSolversTest, PriorTakesPart)
{
  const Pose2 truth{0.4, -0.2, kPi - 1e-3};
  JointProblem problem = jointProblem(truth);
  problem.prior = PriorTerm{{truth.x_m + 0.05, truth.y_m, wrapAngle(truth.phi_rad + 0.02)},
                            information<3>(1e5)};
  Pose2 solution = truth;
  ASSERT_TRUE(solvers_->solveJoint(problem, solution));
  const Eigen::Vector3d remaining = remainingStep(problem, solution);
  EXPECT_LT(remaining.norm(), 1e-6) << "seed " << GetParam();
}

TEST_P(CeresSolversTest, NothingToSolveChangesNothing)
{
  Eigen::Vector2d step_m(1, 2);
  EXPECT_FALSE(solvers_->solveTranslation({}, step_m));
  EXPECT_EQ(step_m, Eigen::Vector2d(1, 2));
  Pose2 pose{1, 2, 3};
  EXPECT_FALSE(solvers_->solveJoint({}, pose));
  EXPECT_TRUE(isNearly(pose, {1, 2, 3}, 0, 0));
}

INSTANTIATE_TEST_SUITE_P(Seeds, CeresSolversTest, testing::Range(1u, 21u));
}  // namespace
}  // namespace psmks
