/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/GaussNewton.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/Cholesky>

namespace psmks
{
namespace
{
class GaussNewtonTest : public testing::TestWithParam<unsigned>
{
 protected:
  GaussNewtonTest() : trace_(__FILE__, __LINE__, random_.seedText()) {}

  Eigen::Vector2d point() { return {random_.uniform(-5, 5), random_.uniform(-5, 5)}; }

  Eigen::Vector2d unit()
  {
    const double angle_rad = random_.uniform(-kPi, kPi);
    return {std::cos(angle_rad), std::sin(angle_rad)};
  }

  Pose2 pose()
  {
    return {random_.uniform(-2, 2), random_.uniform(-2, 2), random_.uniform(-kPi, kPi)};
  }

  /** A line pair that holds at the pose but for an error of some standard deviations. */
  LinePairTerm linePair(const Pose2& truth)
  {
    const double sigma_m = random_.uniform(0.002, 0.02), sigma_rad = random_.uniform(0.001, 0.01);
    const double correlation = random_.uniform(-0.8, 0.8) * sigma_m * sigma_rad;
    Eigen::Matrix2d covariance;
    covariance << sigma_m * sigma_m, correlation, correlation, sigma_rad * sigma_rad;
    const Eigen::Vector2d n = unit(), q = point();
    return {n, n.dot(truth * q) + random_.normal(sigma_m), q,
            wrapAngle(-truth.phi_rad + random_.normal(sigma_rad)),
            covariance.llt().solve(Eigen::Matrix2d::Identity())};
  }

  /** The same of circles: the centre is better known across the view than along it. */
  CirclePairTerm circlePair(const Pose2& truth)
  {
    const Eigen::Vector2d q = point(), along = unit();
    const double across_m = random_.uniform(0.002, 0.01), along_m = random_.uniform(0.01, 0.05);
    const Eigen::Matrix2d towards = along * along.transpose();
    const Eigen::Matrix2d information =
        (Eigen::Matrix2d::Identity() - towards) / (across_m * across_m) +
        towards / (along_m * along_m);
    const Eigen::Vector2d error_m(random_.normal(across_m), random_.normal(across_m));
    return {truth * q + error_m, q, information};
  }

  RayTerm ray(const Pose2& truth, bool pointIsCurrent)
  {
    const Eigen::Vector2d n = unit(), p = point();
    const double d =
        pointIsCurrent ? n.dot(truth * p) : (truth.rotation() * n).dot(p - truth.translation());
    return {pointIsCurrent, p, n, d + random_.normal(0.01), random_.uniform(1e3, 1e4)};
  }

  JointProblem problem(const Pose2& truth)
  {
    JointProblem result;
    for (int i = 0; i < 12; ++i) result.linePairs.push_back(linePair(truth));
    for (int i = 0; i < 6; ++i) result.circlePairs.push_back(circlePair(truth));
    for (int i = 0; i < 20; ++i) result.rays.push_back(ray(truth, i % 2 == 0));
    return result;
  }

  Pose2 near(const Pose2& truth)
  {
    return {truth.x_m + random_.normal(0.05), truth.y_m + random_.normal(0.05),
            wrapAngle(truth.phi_rad + random_.normal(0.02))};
  }

  test::RandomNumbers random_{GetParam()};
  testing::ScopedTrace trace_;
};

INSTANTIATE_TEST_SUITE_P(Seeds, GaussNewtonTest, testing::Range(1u, 21u));

Pose2 shifted(const Pose2& pose, const Eigen::Vector3d& by)
{
  return {pose.x_m + by[0], pose.y_m + by[1], pose.phi_rad + by[2]};
}

/** Derivative by (x, y, phi) of a function of the pose, by central differences. */
template <class Function>
auto numericDerivative(const Pose2& pose, int column, Function f) -> decltype(f(pose))
{
  constexpr double h = 1e-6;
  const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(column);
  return (f(shifted(pose, step)) - f(shifted(pose, -step))) / (2 * h);
}

const SolverLimits kManySteps{50, 1e-10, 1e-10};
}  // namespace

TEST_P(GaussNewtonTest, TheJacobianOfALinePairIsTheNumericOne)
{
  const Pose2 at = pose();
  const LinePairTerm term = linePair(near(at));
  const LinePairResidual analytic = residual(term, at);
  for (int column = 0; column < 3; ++column)
  {
    const Eigen::Vector2d numeric = numericDerivative(
        at, column, [&](const Pose2& T) -> Eigen::Vector2d { return residual(term, T).e; });
    EXPECT_LT((analytic.J.col(column) - numeric).norm(), 1e-7) << "column " << column;
  }
}

TEST_P(GaussNewtonTest, TheJacobianOfACirclePairIsTheNumericOne)
{
  const Pose2 at = pose();
  const CirclePairTerm term = circlePair(near(at));
  const CirclePairResidual analytic = residual(term, at);
  for (int column = 0; column < 3; ++column)
  {
    const Eigen::Vector2d numeric = numericDerivative(
        at, column, [&](const Pose2& T) -> Eigen::Vector2d { return residual(term, T).e; });
    EXPECT_LT((analytic.J.col(column) - numeric).norm(), 1e-7) << "column " << column;
  }
}

TEST_P(GaussNewtonTest, TheJacobiansOfRaysAreTheNumericOnes)
{
  const Pose2 at = pose();
  for (const bool pointIsCurrent : {true, false})
  {
    const RayTerm term = ray(near(at), pointIsCurrent);
    const RayResidual analytic = residual(term, at);
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(
          analytic.J[column],
          numericDerivative(at, column, [&](const Pose2& T) { return residual(term, T).e; }), 1e-7)
          << "column " << column << (pointIsCurrent ? ", current point" : ", reference point");
  }
}

/** What the solver minimises, without a prior. */
double cost(const JointProblem& problem, const Pose2& T_ref_cur)
{
  const double k2 = problem.kernelWidth * problem.kernelWidth;
  const auto rho = [&](double s) { return k2 * std::log1p(s / k2); };
  double sum = 0;
  const auto addPairs = [&](const auto& terms)
  {
    for (const auto& term : terms)
    {
      const Eigen::Vector2d e = residual(term, T_ref_cur).e;
      sum += rho(e.dot(term.information * e)) / 2;
    }
  };
  addPairs(problem.linePairs);
  addPairs(problem.circlePairs);
  for (const RayTerm& term : problem.rays)
  {
    const double e = residual(term, T_ref_cur).e;
    sum += rho(e * e * term.information) / 2;
  }
  return sum;
}

TEST_P(GaussNewtonTest, TheNormalEquationsAreTheSumsOverTheTerms)
{
  const Pose2 truth = pose(), at = near(truth);
  JointProblem p = problem(truth);
  p.prior = PriorTerm{near(truth), Eigen::Vector3d(1e3, 2e3, 5e3).asDiagonal()};

  const double k2 = p.kernelWidth * p.kernelWidth;
  NormalEquations sum;
  for (const LinePairTerm& term : p.linePairs)
  {
    const LinePairResidual r = residual(term, at);
    const double s = r.e.transpose() * term.information * r.e;
    sum.H += r.J.transpose() * term.information * r.J / (1 + s / k2);
    sum.g -= r.J.transpose() * term.information * r.e / (1 + s / k2);
  }
  for (const CirclePairTerm& term : p.circlePairs)
  {
    const CirclePairResidual r = residual(term, at);
    const double s = r.e.transpose() * term.information * r.e;
    sum.H += r.J.transpose() * term.information * r.J / (1 + s / k2);
    sum.g -= r.J.transpose() * term.information * r.e / (1 + s / k2);
  }
  for (const RayTerm& term : p.rays)
  {
    const RayResidual r = residual(term, at);
    const double s = r.e * r.e * term.information;
    sum.H += term.information * r.J.transpose() * r.J / (1 + s / k2);
    sum.g -= term.information * r.e * r.J.transpose() / (1 + s / k2);
  }
  const NormalEquations withoutPrior = linearise(p, at, false);
  EXPECT_LT((withoutPrior.H - sum.H).norm(), 1e-9 * sum.H.norm());
  EXPECT_LT((withoutPrior.g - sum.g).norm(), 1e-9 * sum.g.norm());

  const Eigen::Vector3d e(at.x_m - p.prior->T_ref_cur.x_m, at.y_m - p.prior->T_ref_cur.y_m,
                          wrapAngle(at.phi_rad - p.prior->T_ref_cur.phi_rad));
  const NormalEquations withPrior = linearise(p, at);
  EXPECT_LT((withPrior.H - sum.H - p.prior->information).norm(), 1e-9 * sum.H.norm());
  EXPECT_LT((withPrior.g - sum.g + p.prior->information * e).norm(), 1e-9 * sum.g.norm());
}

TEST_P(GaussNewtonTest, TheGradientIsTheNumericOneOfTheCost)
{
  const Pose2 truth = pose(), at = near(truth);
  const JointProblem p = problem(truth);
  const NormalEquations n = linearise(p, at);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(n.g[i], -numericDerivative(at, i, [&](const Pose2& T) { return cost(p, T); }),
                1e-5 * n.g.norm());
}

TEST_P(GaussNewtonTest, EveryStepLowersTheCostUntilTheGradientIsZero)
{
  const Pose2 truth = pose();
  const JointProblem p = problem(truth);
  Pose2 estimate = near(truth);
  const double gradientAtStart = linearise(p, estimate).g.norm();
  for (int step = 0; step < 4; ++step)
  {
    const double before = cost(p, estimate);
    solveByGaussNewton(p, {1, 0, 0}, estimate);
    EXPECT_LE(cost(p, estimate), before * (1 + 1e-12)) << "step " << step;
  }
  EXPECT_TRUE(solveByGaussNewton(p, kManySteps, estimate).converged);
  EXPECT_LT(linearise(p, estimate).g.norm(), 1e-6 * gradientAtStart);
  EXPECT_TRUE(isNearly(estimate, truth, 0.02, degToRad(0.5)));
}

TEST_P(GaussNewtonTest, OneLineMovesThePoseAcrossItselfOnly)
{
  const Pose2 truth{0, 0, 0.2};
  JointProblem p;
  const Eigen::Vector2d n = unit(), along(-n.y(), n.x());
  p.linePairs.push_back(
      {n, 2, truth.inverse() * (2 * n), -truth.phi_rad, Eigen::Vector2d(1e4, 1e5).asDiagonal()});
  Pose2 estimate{0.03 * n.x() + 0.04 * along.x(), 0.03 * n.y() + 0.04 * along.y(), 0.2};
  solveByGaussNewton(p, kManySteps, estimate);
  EXPECT_NEAR(n.dot(estimate.translation()), 0, 1e-4);
  EXPECT_NEAR(along.dot(estimate.translation()), 0.04, 1e-4);
}

// Two pillars fix the pose, as two points do; one leaves the heading as it is.
TEST_P(GaussNewtonTest, TwoCirclesFixThePose)
{
  const Pose2 truth = pose();
  const Eigen::Vector2d first(2, 1), second(-1, 3);
  const Eigen::Matrix2d information = 1e4 * Eigen::Matrix2d::Identity();
  JointProblem p;
  p.circlePairs.push_back({truth * first, first, information});
  p.circlePairs.push_back({truth * second, second, information});
  Pose2 estimate = near(truth);
  EXPECT_TRUE(solveByGaussNewton(p, kManySteps, estimate).converged);
  EXPECT_TRUE(isNearly(estimate, truth, 1e-6, 1e-6));
}

TEST(GaussNewton, WithoutTermsThePoseStays)
{
  Pose2 estimate{1, 2, 3};
  EXPECT_TRUE(solveByGaussNewton({}, {10, 1e-4, 1e-4}, estimate).converged);
  EXPECT_TRUE(isNearly(estimate, {1, 2, 3}, 0, 0));
}
}  // namespace psmks
