/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/joint/JointScheme.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
// The room of officeRoom(): the scanner has gone 2.2 m and turned by 75 degrees, which is more than
// is searched for near a guess, and nobody measured how far.
class JointSchemeFarFromTheGuess : public testing::Test
{
 protected:
  /** Whether one of the poses that are tried is the true one. */
  bool triesTheTruth(const JointOptions& options, SearchScope scope)
  {
    MatchTrace trace;
    JointBuffers buffers;
    matchByJointScheme(reference_, current_, Guess{}, scope, options, nullptr, buffers, &trace);
    EXPECT_FALSE(trace.steps.empty());
    return std::any_of(trace.steps.begin(), trace.steps.end(),
                       [&](const MatchTrace::Step& step)
                       { return isNearly(step.T_ref_cur, kFar, 0.05, degToRad(1)); });
  }

  static SegmentedScan scanFrom(const Pose2& T)
  {
    const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
    return segmentByWalls(castScan(officeRoom(), T, grid), officeRoom(), T);
  }

  const Pose2 kFar{1.4, 1.7, degToRad(75)};
  const SegmentedScan reference_ = scanFrom({}), current_ = scanFrom(kFar);
  const JointOptions options_{};
};
}  // namespace

TEST_F(JointSchemeFarFromTheGuess, InFullThePoseIsTried)
{
  ASSERT_GT(kFar.phi_rad, options_.searchAngle_rad);
  EXPECT_TRUE(triesTheTruth(options_, SearchScope::Full));
}

TEST_F(JointSchemeFarFromTheGuess, NearTheGuessThePoseIsNotTried)
{
  EXPECT_FALSE(triesTheTruth(options_, SearchScope::NearGuess));
}

TEST_F(JointSchemeFarFromTheGuess, AWideRadiusOfZeroSwitchesTheWideSearchOff)
{
  JointOptions narrow = options_;
  narrow.wideRadius_m = 0;
  EXPECT_FALSE(triesTheTruth(narrow, SearchScope::Full));
}

// The guess is 7 m and 100 degrees off, which its covariance bears.
TEST(JointScheme, SearchesAsFarAsTheCovarianceOfTheGuessLeavesOpen)
{
  const Pose2 truth{0.4, 0.3, degToRad(20)};
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Scan reference = castScan(officeRoom(), {}, grid);
  const Scan current = castScan(officeRoom(), truth, grid);
  const auto matchedWith = [&](double sigma_m, double sigma_deg)
  {
    const Eigen::Vector3d sigma(sigma_m, sigma_m, degToRad(sigma_deg));
    Guess guess{{truth.x_m + 5, truth.y_m - 5, truth.phi_rad + degToRad(100)}, std::nullopt};
    guess.covariance = sigma.cwiseAbs2().asDiagonal();
    MatcherWorkspace workspace;
    return Matcher().match(reference, current, guess, workspace, nullptr,
                           SearchScope::WithinCovariance);
  };
  const MatchResult found = matchedWith(3, 45);
  ASSERT_TRUE(found.usable()) << found.report();
  EXPECT_TRUE(isNearly(found.T_ref_cur, truth, 0.02, degToRad(0.5)));
  const MatchResult tooNarrow = matchedWith(0.3, 5);
  EXPECT_FALSE(tooNarrow.usable() && isNearly(tooNarrow.T_ref_cur, truth, 1, 1));
}

// A square room looks the same after a quarter turn. All optima are looked at, though the guess
// scores well and would end any other search.
TEST(JointScheme, WithinTheCovarianceItTellsOfEveryPlaceThatLooksAlike)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Scan scan = castScan(squareRoom(), {}, grid);
  Guess guess;
  guess.covariance = Eigen::Vector3d(0.01, 0.01, std::pow(degToRad(40), 2)).asDiagonal();
  MatcherWorkspace workspace;
  const MatchResult result =
      Matcher().match(scan, scan, guess, workspace, nullptr, SearchScope::WithinCovariance);
  ASSERT_TRUE(result.ambiguity) << result.report();
  const MatchResult near =
      Matcher().match(scan, scan, guess, workspace, nullptr, SearchScope::NearGuess);
  EXPECT_FALSE(near.ambiguity);
}

// The wheels say that the robot stood still, to 3 cm and 2 degrees; it was pushed about. All steps
// are needed: the guess is refined, doubted, given up, and the pose accepted all the same.
TEST(JointScheme, FindsTheRobotWhereItsWheelsSlipped)
{
  const Pose2 pushed{0.4, 0.3, degToRad(75)};
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Eigen::Vector3d sigma(0.03, 0.03, degToRad(2));
  Guess guess;
  guess.covariance = sigma.cwiseAbs2().asDiagonal();
  const Scan reference = castScan(officeRoom(), {}, grid);
  const Scan current = castScan(officeRoom(), pushed, grid);
  MatcherWorkspace workspace;
  const MatchResult result = Matcher().match(reference, current, guess, workspace);
  ASSERT_TRUE(result.usable()) << result.report();
  // The scans are exact: what is left is the rounding of the last steps.
  EXPECT_TRUE(isNearly(result.T_ref_cur, pushed, 0.01, degToRad(0.2))) << result.report();
}

//        .     .           small boxes of a hand's breadth to 45 cm about a scanner that sees half
//    '      o      .       round: hardly any is seen by enough rays to be a line that votes
//       .       '
class JointSchemeAmongBoxes : public testing::Test
{
 protected:
  static std::vector<Wall> boxes()
  {
    constexpr int kBoxes = 9;
    std::mt19937 rng(5);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Wall> walls;
    for (int k = 0; k < kBoxes; ++k)
    {
      const double bearing_rad = 2 * kPi * (k + share(rng)) / kBoxes;
      const double distance_m = 1.5 + 4 * share(rng), length_m = 0.25 + 0.2 * share(rng);
      const Eigen::Vector2d centre_m(distance_m * std::cos(bearing_rad),
                                     distance_m * std::sin(bearing_rad));
      for (const Wall& wall : box(centre_m, length_m, 0.25, 3 * share(rng))) walls.push_back(wall);
    }
    return walls;
  }

  /** From a guess that was measured, with 15 cm and 12 degrees, and is wrong by more. */
  MatchResult match(SearchScope scope) const
  {
    const BeamGrid grid = BeamGrid::centered(kPi, 181);
    constexpr double kReach_m = 8, kSigma_m = 0.01;
    std::mt19937 noise(5);
    const Scan reference = castScan(boxes(), {}, grid, kReach_m, kSigma_m, noise);
    const Scan current = castScan(boxes(), kMoved, grid, kReach_m, kSigma_m, noise);
    Guess guess;
    const Eigen::Vector3d sigma(0.15, 0.15, degToRad(12));
    guess.covariance = sigma.cwiseAbs2().asDiagonal();
    MatcherWorkspace workspace;
    return Matcher().match(reference, current, guess, workspace, nullptr, scope);
  }

  const Pose2 kMoved{0.15, 0.1, degToRad(20)};
};

// Some 50 rays of either scan with 1 cm of noise lie on boxes that face all ways: the best estimate
// is known to 2 mm and, at 4 m, to 0.05 degrees. Ten times that tells the pose from any other.
TEST_F(JointSchemeAmongBoxes, FindsWhatNoLineVotesForAboutAMeasuredGuess)
{
  for (const SearchScope scope : {SearchScope::Full, SearchScope::NearGuess})
  {
    const MatchResult result = match(scope);
    ASSERT_TRUE(result.usable()) << result.report();
    EXPECT_TRUE(isNearly(result.T_ref_cur, kMoved, 0.02, degToRad(0.5))) << result.report();
    EXPECT_FALSE(result.guessGivenUp) << "the pose lies within three standard deviations";
  }
}
}  // namespace psmks
