/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/PoseObjective.h>
#include <psmks/paper/TranslationRegression.h>
#include <tests/support/Scenes.h>

#include <Eigen/Eigenvalues>

namespace psmks
{
namespace
{
class TranslationRegressionTest : public testing::Test
{
 protected:
  void scan(const std::vector<Wall>& walls, const Pose2& T, double maxRange_m)
  {
    reference_ = segmentByWalls(castScan(walls, {}, grid_, maxRange_m), walls, {});
    current_ = segmentByWalls(castScan(walls, T, grid_, maxRange_m), walls, T);
    objective_.assign(reference_, current_, options_);
  }

  /** One association and one regression at a given pose. */
  Eigen::Vector2d stepAt(const Pose2& supposed, TranslationJacobian jacobian)
  {
    objective_.evaluate(supposed, supposed.phi_rad);
    buildTranslationProblem(objective_.projection(), objective_.associations(),
                            objective_.reliability(), jacobian, problem_);
    return solveTranslation(problem_);
  }

  /** The smaller over the larger eigenvalue of the normal matrix of the last problem. */
  double informationShare() const
  {
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    for (const TranslationTerm& t : problem_.terms) A += t.weight * t.slope * t.slope.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(A);
    return eigen.eigenvalues()[0] / eigen.eigenvalues()[1];
  }

  BeamGrid grid_ = BeamGrid::centered(2 * kPi, 720);
  SegmentedScan reference_, current_;
  PaperOptions options_;
  PoseObjective objective_;
  TranslationProblem problem_;
};

// A point on the line, and the same point moved by a small step: the residual r0 / cos(b - phi0) -
// r changes by the slope.
TEST_F(TranslationRegressionTest, FullSlopeEqualsTheNumericOne)
{
  std::mt19937 rng(5);
  const auto between = [&rng](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(rng); };
  for (int trial = 0; trial < 100; ++trial)
  {
    Line line;
    line.r0_m = between(0.5, 5);
    line.phi0_rad = between(-kPi, kPi);
    const double bearing_rad = line.phi0_rad + between(-1.3, 1.3);
    const Eigen::Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
    const Eigen::Vector2d point = line.rangeAt_m(bearing_rad) * direction;
    const auto residualAt = [&](const Eigen::Vector2d& p)
    { return line.rangeAt_m(std::atan2(p.y(), p.x())) - p.norm(); };

    constexpr double h = 1e-6;
    const Eigen::Vector2d numeric((residualAt(point + h * Eigen::Vector2d::UnitX()) -
                                   residualAt(point - h * Eigen::Vector2d::UnitX())) /
                                      (2 * h),
                                  (residualAt(point + h * Eigen::Vector2d::UnitY()) -
                                   residualAt(point - h * Eigen::Vector2d::UnitY())) /
                                      (2 * h));
    const Eigen::Vector2d analytic =
        residualSlope(TranslationJacobian::Full, direction, line.normal());
    EXPECT_LT((numeric - analytic).norm(), 1e-6) << "trial " << trial;
  }
}

TEST_F(TranslationRegressionTest, FullJacobianSolvesARoomInOneStep)
{
  const Pose2 T{0.3, -0.2, 0.1};
  scan(squareRoom(), T, 30);
  const Eigen::Vector2d step_m = stepAt({0.38, -0.11, 0.1}, TranslationJacobian::Full);
  EXPECT_NEAR(step_m.x(), -0.08, 1e-3);
  EXPECT_NEAR(step_m.y(), -0.09, 1e-3);
}

//   ------------------------------   A bare corridor, seen 8 m far. The current scan stands 5 cm
//        o ->                        to the left of where it is supposed to stand.
//   ------------------------------
class CorridorRegressionTest : public TranslationRegressionTest
{
 protected:
  void SetUp() override { scan(corridor(), {0, lateral_m_, 0}, 8); }

  const double lateral_m_ = 0.05;
};

TEST_F(CorridorRegressionTest, FullJacobianSolvesTheLateralErrorInOneStepAndStaysPut)
{
  const Eigen::Vector2d step_m = stepAt({}, TranslationJacobian::Full);
  EXPECT_NEAR(step_m.y(), lateral_m_, 1e-3);
  EXPECT_NEAR(step_m.x(), 0, 1e-6);
  EXPECT_LT(informationShare(), 1e-6);
}

TEST_F(CorridorRegressionTest, FrozenBearingOvershootsAndInventsInformation)
{
  const Eigen::Vector2d step_m = stepAt({}, TranslationJacobian::FrozenBearing);
  EXPECT_GT(step_m.y(), 1.5 * lateral_m_);
  EXPECT_GT(informationShare(), 0.3);
}

// The directions of the walls differ a little between the two scans, as with noise.
TEST_F(CorridorRegressionTest, NoiseInTheNormalsIsNoInformation)
{
  reference_.segments[0].line.phi0_rad += degToRad(0.3);
  EXPECT_NEAR(stepAt({}, TranslationJacobian::Full).x(), 0, 0.02);
}

TEST_F(TranslationRegressionTest, ReliableSegmentsDecide)
{
  // Two walls ahead give different steps along x; the first one has the larger weight.
  const Eigen::Vector2d ahead(-1, 0), left(0, -1);
  problem_.terms = {{0.02, ahead, 900}, {0.12, ahead, 100}, {0.0, left, 500}};
  EXPECT_NEAR(solveTranslation(problem_).x(), 0.9 * 0.02 + 0.1 * 0.12, 1e-12);
}

TEST_F(TranslationRegressionTest, NoRaysNoStep)
{
  EXPECT_EQ(solveTranslation({}), Eigen::Vector2d::Zero().eval());
}
}  // namespace
}  // namespace psmks
