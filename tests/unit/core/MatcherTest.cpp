/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Says.h>
#include <tests/support/Scenes.h>
#include <tests/support/ThrownText.h>

#include <limits>

namespace psmks
{
namespace
{
const BeamGrid kGrid = BeamGrid::centered(kPi, 361);
const Pose2 kMotion{0.15, -0.08, degToRad(6)};

Scan office(const Pose2& T_world_sensor, unsigned seed = 1)
{
  std::mt19937 rng(seed);
  return castScan(officeRoom(), T_world_sensor, kGrid, 30, 0.01, rng);
}

Scan nothingSeen()
{
  Scan scan = office({});
  scan.range_m.assign(scan.range_m.size(), std::numeric_limits<double>::quiet_NaN());
  return scan;
}

class MatcherTest : public testing::TestWithParam<Scheme>
{
 protected:
  static MatcherOptions options()
  {
    return GetParam() == Scheme::Joint ? MatcherOptions{} : MatcherOptions::paperScheme();
  }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess = {})
  {
    const MatchResult result = matcher_.match(reference, current, guess, workspace_);
    EXPECT_GT(result.covariance.diagonal().minCoeff(), 0) << result.report();
    return result;
  }

  const Matcher matcher_{options()};
  MatcherWorkspace workspace_;
};

INSTANTIATE_TEST_SUITE_P(Schemes, MatcherTest, testing::Values(Scheme::Joint, Scheme::Paper),
                         [](const auto& scheme) -> std::string
                         { return scheme.param == Scheme::Joint ? "Joint" : "Paper"; });
}  // namespace

TEST_P(MatcherTest, FindsTheMotionBetweenTwoScans)
{
  const MatchResult result = match(office({}), office(kMotion, 2));
  EXPECT_TRUE(result.usable()) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, kMotion, 0.02, degToRad(0.3))) << result.report();
  EXPECT_GT(result.score, 0.8);
  EXPECT_GT(result.associations, 200);
  EXPECT_GT(result.iterations, 0);
  if (GetParam() == Scheme::Paper)
  {
    EXPECT_LT(result.errorAfter, result.errorBefore);
  }
}

TEST_P(MatcherTest, SegmentedScansGiveTheSameAsRawOnes)
{
  SegmentedScan reference, current;
  matcher_.segment(office({}), workspace_, reference);
  matcher_.segment(office(kMotion, 2), workspace_, current);
  const MatchResult segmented = matcher_.match(reference, current, {}, workspace_);
  const MatchResult raw = match(office({}), office(kMotion, 2));
  EXPECT_TRUE(isNearly(segmented.T_ref_cur, raw.T_ref_cur, 0, 0));
  EXPECT_EQ(segmented.covariance, raw.covariance);
  EXPECT_EQ(segmented.times.segmentation_s, 0);
}

TEST_P(MatcherTest, AScanWithoutAValidRayIsInvalidInput)
{
  const Guess guess{{0.1, 0.2, 0.3}, {}};
  for (const MatchResult& result : {match(nothingSeen(), office({}), guess),
                                    match(office({}), nothingSeen(), guess), match({}, {}, guess)})
  {
    EXPECT_EQ(result.status, MatchStatus::InvalidInput);
    EXPECT_TRUE(isNearly(result.T_ref_cur, guess.T_ref_cur, 0, 0));
    EXPECT_EQ(result.covariance, MatchResult::unknownCovariance());
  }
}

TEST_P(MatcherTest, AGuessThatMeansNothingIsInvalidInput)
{
  const double nan = std::nan("");
  Eigen::Matrix3d notSymmetric = Eigen::Matrix3d::Identity();
  notSymmetric(0, 1) = 0.5;
  for (const Guess& guess :
       {Guess{{nan, 0, 0}, {}}, Guess{{0, INFINITY, 0}, {}},
        Guess{{}, Eigen::Matrix3d::Constant(nan)}, Guess{{}, Eigen::Matrix3d::Zero().eval()},
        Guess{{}, (-Eigen::Matrix3d::Identity()).eval()}, Guess{{}, notSymmetric}})
  {
    const MatchResult result = match(office({}), office(kMotion, 2), guess);
    EXPECT_EQ(result.status, MatchStatus::InvalidInput);
    EXPECT_TRUE(result.T_ref_cur.isFinite());
    EXPECT_EQ(result.covariance, MatchResult::unknownCovariance());
  }
}

// Two rooms that have nothing in common: the guess comes back with its covariance.
TEST_P(MatcherTest, AFailureKeepsTheGuess)
{
  Guess guess{{0.1, 0.2, 0.3}, Eigen::Vector3d(0.01, 0.02, 0.03).asDiagonal()};
  const Scan elsewhere = castScan(box({1.3, 0.4}, 2.1, 1.7, 0.6), {}, kGrid);
  const MatchResult result = match(office({}), elsewhere, guess);
  EXPECT_FALSE(result.usable()) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, guess.T_ref_cur, 0, 0));
  EXPECT_EQ(result.covariance, *guess.covariance);
}

TEST_P(MatcherTest, FewRaysAreTooFew)
{
  Scan few = office({});
  for (std::size_t i = 4; i < few.range_m.size(); ++i) few.range_m[i] = 0;
  EXPECT_EQ(match(office({}), few).status, MatchStatus::TooFewAssociations);
}

TEST_P(MatcherTest, TheTraceShowsEveryStep)
{
  MatchTrace trace;
  const MatchResult result = matcher_.match(office({}), office(kMotion, 2), {}, workspace_, &trace);
  ASSERT_FALSE(trace.steps.empty());
  bool found = false;
  for (const MatchTrace::Step& step : trace.steps)
  {
    found = found || isNearly(step.T_ref_cur, result.T_ref_cur, 0.01, degToRad(0.1));
    EXPECT_EQ(step.score.has_value(), GetParam() == Scheme::Joint) << step.stage;
    EXPECT_EQ(step.matchingError.has_value(), GetParam() == Scheme::Paper) << step.stage;
  }
  EXPECT_TRUE(found) << "no step is near the result";
}

// ---- what only the joint scheme does
// -------------------------------------------------------------

TEST(JointMatcher, FindsAMotionFarFromTheGuess)
{
  const Matcher matcher;
  MatcherWorkspace workspace;
  const Pose2 far{0.8, -0.5, degToRad(40)};
  const MatchResult result = matcher.match(office({}), office(far, 2), {}, workspace);
  EXPECT_TRUE(isNearly(result.T_ref_cur, far, 0.02, degToRad(0.3))) << result.report();
  EXPECT_GT(result.hypotheses, 0);
}

// A guess that is known to the millimetre outweighs the scans; as a mere start it has no weight.
TEST(JointMatcher, AGuessWithACovarianceIsAMeasurement)
{
  const Matcher matcher;
  MatcherWorkspace workspace;
  const double sigma_m = 1e-4, sigma_rad = 1e-5;
  const Pose2 off{kMotion.x_m + 0.01, kMotion.y_m, kMotion.phi_rad};
  const Guess certain{
      off,
      Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal()};
  const MatchResult withPrior = matcher.match(office({}), office(kMotion, 2), certain, workspace);
  const MatchResult without = matcher.match(office({}), office(kMotion, 2), {off, {}}, workspace);
  EXPECT_NEAR(withPrior.T_ref_cur.x_m, off.x_m, 0.001) << withPrior.report();
  EXPECT_NEAR(without.T_ref_cur.x_m, kMotion.x_m, 0.006) << without.report();
  EXPECT_LT(withPrior.covariance(0, 0), without.covariance(0, 0));
}

//           |                        |    a room and, below it, the end of a corridor; the wall
//           |  cur                   |    between them is 15 cm thick and has an open door. Only
//           +=======             ====+    cur sees the upper face of the wall, only ref the lower
//                     door      +----+    one, which lies to the right of the door: 15 cm are
//                ref                 |    less than the distance at which lines are first paired.
//           -------------------------+
TEST(JointMatcher, AStartAtTheTruthIsNotDrawnToTheOtherFaceOfAWall)
{
  const std::vector<Wall> walls{{{-1.3, -0.9}, {2, -0.9}},   {{2, -0.9}, {2, 0.9}},
                                {{2, 0.9}, {1.5, 0.9}},      {{1.5, 0.9}, {1.5, 1.05}},
                                {{1.5, 1.05}, {1.95, 1.05}}, {{1.95, 1.05}, {1.95, 5.05}},
                                {{0.3, 1.05}, {-1.75, 1.05}}};
  const BeamGrid grid = BeamGrid::centered(kPi, 181);
  const Pose2 T_world_ref{0.35, -0.15, degToRad(-24)}, T_ref_cur{-1.3, 1.45, degToRad(3)};
  const Matcher matcher;
  MatcherWorkspace workspace;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    std::mt19937 rng(seed);
    const Scan reference = castScan(walls, T_world_ref, grid, 30, 0.01, rng);
    const Scan current = castScan(walls, T_world_ref * T_ref_cur, grid, 30, 0.01, rng);
    const MatchResult result = matcher.match(reference, current, {T_ref_cur, {}}, workspace);
    EXPECT_TRUE(result.usable()) << result.report();
    EXPECT_TRUE(isNearly(result.T_ref_cur, T_ref_cur, 0.035, degToRad(0.3))) << result.report();
  }
}

TEST(Matcher, CeresWithoutItsSolversIsRefused)
{
  MatcherOptions joint, paper;
  joint.joint.solver = JointSolver::Ceres;
  paper.paper.translationSolver = TranslationSolver::Ceres;
  for (const MatcherOptions& options : {joint, paper})
    EXPECT_TRUE(test::says(test::thrownText<OptionError>([&] { Matcher{options}; }), {"ceres"}));
}

TEST(Matcher, OptionsThatCodeSetOutOfRangeAreRefused)
{
  MatcherOptions options;
  options.joint.acceptScore = 1.5;
  EXPECT_TRUE(test::says(test::thrownText<OptionError>([&] { Matcher{options}; }),
                         {"accept_score", "1.5", "0 to 1"}));
}
}  // namespace psmks
