/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/PaperScheme.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

namespace psmks
{
namespace
{
class PaperSchemeTest : public testing::Test
{
 protected:
  /** Casts two scans of a room, the first one from the origin. */
  void scan(const std::vector<Wall>& walls, const Pose2& T, double sigma_m = 0,
            double maxRange_m = 30)
  {
    reference_ = segmentByWalls(castScan(walls, {}, grid_, maxRange_m, sigma_m, rng_), walls, {});
    current_ = segmentByWalls(castScan(walls, T, grid_, maxRange_m, sigma_m, rng_), walls, T);
  }

  MatchResult match(const Guess& guess, MatchTrace* trace = nullptr)
  {
    return matchByPaperScheme(reference_, current_, guess, options_, nullptr, buffers_, trace);
  }

  BeamGrid grid_ = BeamGrid::centered(kPi, 361);
  std::mt19937 rng_{11};
  SegmentedScan reference_, current_;
  PaperOptions options_;
  PaperBuffers buffers_;
};

bool isProper(const Eigen::Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  return covariance.allFinite() && eigen.eigenvalues()[0] > 0;
}

TEST_F(PaperSchemeTest, FindsTheMotionBetweenExactScans)
{
  const Pose2 T{0.12, -0.08, degToRad(6.3)};
  scan(officeRoom(), T);
  for (const auto jacobian : {TranslationJacobian::FrozenBearing, TranslationJacobian::Full})
  {
    options_.jacobian = jacobian;
    const MatchResult result = match({});
    EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
    EXPECT_TRUE(isNearly(result.T_ref_cur, T, 0.005, degToRad(0.15)));
    EXPECT_LT(result.errorAfter, result.errorBefore);
    EXPECT_GT(result.associations, 250);
    EXPECT_GT(result.score, 0.95);
    EXPECT_TRUE(isProper(result.covariance));
  }
}

TEST_F(PaperSchemeTest, AScanMatchesItself)
{
  scan(officeRoom(), {});
  const MatchResult result = match({});
  EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, {}, 1e-6, 1e-6));
}

TEST_F(PaperSchemeTest, FindsTheMotionAcrossTheSeamOfAClosedScan)
{
  grid_ = BeamGrid::centered(2 * kPi, 720);
  const Pose2 T{0.1, 0.05, degToRad(179.3)};
  scan(officeRoom(), T);
  const MatchResult result = match({{0.05, 0.0, degToRad(-176)}, {}});
  EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, T, 0.005, degToRad(0.15)));
}

TEST_F(PaperSchemeTest, AcceptsOnlyUpdatesThatLowerTheError)
{
  scan(officeRoom(), {0.12, -0.08, degToRad(6.3)}, 0.01);
  MatchTrace trace;
  const MatchResult result = match({}, &trace);
  ASSERT_TRUE(result.usable()) << result.report();
  ASSERT_EQ(trace.steps.size(), 2U * static_cast<std::size_t>(result.iterations));
  double least = result.errorBefore;
  for (std::size_t k = 1; k < trace.steps.size(); k += 2)
  {
    EXPECT_EQ(trace.steps[k - 1].stage, "orientation");
    EXPECT_EQ(trace.steps[k].stage, "translation");
    least = std::min(least, *trace.steps[k].matchingError);
  }
  EXPECT_DOUBLE_EQ(result.errorAfter, least);
}

//   ----------------------   Looking along a corridor, 60 degrees to either side, the paper's
//     o -> < field of view    Jacobian asks for a step more than twice too long: the error would
//     rise.
//   ----------------------
TEST_F(PaperSchemeTest, WithoutImprovementTheGuessStands)
{
  grid_ = BeamGrid::centered(degToRad(120), 361);
  const Pose2 T{0, 0.04, 0};
  scan(corridor(), T, 0, 8);
  options_.coarseRange_rad = options_.fineRange_rad = 0;
  options_.jacobian = TranslationJacobian::FrozenBearing;
  options_.stepHalvings = 0;
  const MatchResult rejected = match({});
  EXPECT_EQ(rejected.status, MatchStatus::NoImprovement) << rejected.report();
  EXPECT_TRUE(isNearly(rejected.T_ref_cur, {}, 0, 0));

  options_.jacobian = TranslationJacobian::Full;
  EXPECT_NEAR(match({}).T_ref_cur.y_m, T.y_m, 1e-3);

  options_.jacobian = TranslationJacobian::FrozenBearing;
  options_.stepHalvings = 3;
  EXPECT_NEAR(match({}).T_ref_cur.y_m, T.y_m, 2e-3);
}

TEST_F(PaperSchemeTest, TooFewRaysKeepTheGuessAndItsCovariance)
{
  scan(officeRoom(), {0.1, 0, 0});
  options_.minAssociations = 400;
  Guess guess{{0.2, 0.1, 0.05}, {}};
  MatchResult result = match(guess);
  EXPECT_EQ(result.status, MatchStatus::TooFewAssociations);
  EXPECT_TRUE(isNearly(result.T_ref_cur, guess.T_ref_cur, 0, 0));
  EXPECT_EQ(result.covariance, MatchResult::unknownCovariance());

  guess.covariance = Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal();
  result = match(guess);
  EXPECT_EQ(result.covariance, *guess.covariance);
}

TEST_F(PaperSchemeTest, LargeResidualsAtTheEndFail)
{
  scan(officeRoom(), {0.12, -0.08, degToRad(6.3)}, 0.01);
  options_.maxResidual_m = 1e-3;
  const MatchResult result = match({});
  EXPECT_EQ(result.status, MatchStatus::NoImprovement);
  EXPECT_TRUE(isNearly(result.T_ref_cur, {}, 0, 0));
}

// The orientation search lowers the error by a factor of a hundred. A translation step must not
// raise it again.
TEST_F(PaperSchemeTest, NoTranslationStepRaisesTheErrorThatTheOrientationLeft)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    scan(clutteredRoom(seed), {0.3, -0.1, degToRad(6.36)}, 0.01);
    MatchTrace trace;
    match({{0.305, -0.097, degToRad(5)}, {}}, &trace);
    ASSERT_GE(trace.steps.size(), 2U);
    for (std::size_t k = 1; k < trace.steps.size(); k += 2)
    {
      const MatchTrace::Step& turned = trace.steps[k - 1];
      const MatchTrace::Step& shifted = trace.steps[k];
      const bool gainsRays = turned.kept < options_.minAssociationShare * shifted.kept;
      EXPECT_TRUE(gainsRays || *shifted.matchingError <= *turned.matchingError) << seed;
    }
  }
}

//   ------------------------------   Along a bare corridor the position is that of the guess, and
//   the
//        o ->                        result reports it. Across it and in heading the scans decide.
//   ------------------------------
TEST_F(PaperSchemeTest, AlongACorridorTheGuessStands)
{
  grid_ = BeamGrid::centered(2 * kPi, 720);
  const Pose2 T{0.3, 0.06, degToRad(2.5)};
  scan(corridor(), T, 0.01, 8);
  const Guess guess{{0.25, 0.02, degToRad(1)}, {}};
  for (const auto jacobian : {TranslationJacobian::FrozenBearing, TranslationJacobian::Full})
  {
    options_.jacobian = jacobian;
    const MatchResult result = match(guess);
    ASSERT_EQ(result.status, MatchStatus::Degenerate) << result.report();
    ASSERT_TRUE(result.unobservableDirection);
    EXPECT_GT(std::abs(result.unobservableDirection->x()), 0.999);
    EXPECT_NEAR(result.T_ref_cur.x_m, 0.25, 2e-3);
    EXPECT_NEAR(result.T_ref_cur.y_m, T.y_m, 5e-3);
    EXPECT_NEAR(result.T_ref_cur.phi_rad, T.phi_rad, degToRad(0.15));
    EXPECT_GT(result.covariance(0, 0), 0.5);
    EXPECT_LT(result.covariance(1, 1), 1e-4);
    EXPECT_TRUE(isProper(result.covariance));
  }
}

// Over many noisy pairs the mean of x' P^-1 x is 3 if the covariance P of the error x is right. The
// scheme stops before its optimum, which raises the mean a little.
TEST_F(PaperSchemeTest, CovarianceMatchesTheErrors)
{
  constexpr int kPairs = 100;
  double sum = 0;
  for (int k = 0; k < kPairs; ++k)
  {
    const Pose2 T{0.1, -0.05, degToRad(4)};
    scan(clutteredRoom(static_cast<unsigned>(k % 10)), T, 0.01);
    const MatchResult result = match({{0.12, -0.04, degToRad(4.5)}, {}});
    ASSERT_TRUE(result.usable()) << result.report();
    const Eigen::Vector3d error(result.T_ref_cur.x_m - T.x_m, result.T_ref_cur.y_m - T.y_m,
                                wrapAngle(result.T_ref_cur.phi_rad - T.phi_rad));
    sum += error.dot(result.covariance.inverse() * error);
  }
  EXPECT_GT(sum / kPairs, 1.5);
  EXPECT_LT(sum / kPairs, 6);
}

TEST_F(PaperSchemeTest, TinyAndEmptyScansNeverThrow)
{
  for (int rays = 0; rays <= 3; ++rays)
  {
    grid_ = rays > 0 ? BeamGrid(-0.5, 0.5, rays) : BeamGrid();
    scan(squareRoom(), {});
    const MatchResult result = match({{0.1, 0.2, 0.3}, {}});
    EXPECT_EQ(result.status, MatchStatus::TooFewAssociations) << rays;
    EXPECT_TRUE(isNearly(result.T_ref_cur, {0.1, 0.2, 0.3}, 0, 0));
  }
}

TEST_F(PaperSchemeTest, AGuessThatIsNotFiniteIsInvalid)
{
  scan(squareRoom(), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MatchResult result = match({{nan, 0, 0}, {}});
  EXPECT_EQ(result.status, MatchStatus::InvalidInput);
  EXPECT_TRUE(result.T_ref_cur.isFinite());
}

TEST_F(PaperSchemeTest, BuffersMayServeScansOfOtherSizes)
{
  const Pose2 T{0.05, 0.02, degToRad(2)};
  for (const int rays : {361, 91, 721})
  {
    grid_ = BeamGrid::centered(kPi, rays);
    scan(squareRoom(), T);
    const MatchResult result = match({});
    EXPECT_TRUE(isNearly(result.T_ref_cur, T, 0.01, degToRad(0.1))) << rays;
  }
}
}  // namespace
}  // namespace psmks
