/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
// The room of castScan(officeRoom()): the scanner has gone 2.2 m and turned by 75 degrees, more
// than is searched for about a guess; nobody measured how far.
const Pose2 kFar{1.4, 1.7, degToRad(75)};

MatchResult matchFar(const MatcherOptions& options)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  MatcherWorkspace workspace;
  return Matcher(options).match(castScan(officeRoom(), {}, grid),
                                castScan(officeRoom(), kFar, grid), Guess{}, workspace);
}
}  // namespace

TEST(CorrelativeSearch, FindsWhatIsFartherThanTheSearchAboutTheGuess)
{
  const MatchResult result = matchFar({});
  ASSERT_TRUE(result.usable()) << result.report();
  EXPECT_LT((result.T_ref_cur.translation() - kFar.translation()).norm(), 0.01);
  EXPECT_LT(std::abs(wrapAngle(result.T_ref_cur.phi_rad - kFar.phi_rad)), degToRad(0.2));
}

TEST(CorrelativeSearch, IsSwitchedOffByARadiusOfZero)
{
  MatcherOptions options;
  options.joint.wideRadius_m = 0;
  const MatchResult result = matchFar(options);
  EXPECT_TRUE(!result.usable() ||
              (result.T_ref_cur.translation() - kFar.translation()).norm() > 0.5)
      << result.report();
}

TEST(CorrelativeSearch, FindsTheRobotWhereItsWheelsSlipped)
{
  // The wheels say that it stood still, to 3 cm and 2 degrees; it was pushed about.
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
  EXPECT_LT((result.T_ref_cur.translation() - pushed.translation()).norm(), 0.01);
  EXPECT_LT(std::abs(wrapAngle(result.T_ref_cur.phi_rad - pushed.phi_rad)), degToRad(0.2));
}

//        .     .           small boxes of a hand's breadth to 45 cm about a scanner that sees half
//    '      o      .       round: hardly any is seen by enough rays to be a line that votes
//       .       '
class WideSearchAmongBoxes : public testing::Test
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

TEST_F(WideSearchAmongBoxes, FindsWhatNoLineVotesForAboutAMeasuredGuess)
{
  const MatchResult result = match(SearchScope::Full);
  ASSERT_TRUE(result.usable()) << result.report();
  EXPECT_LT((result.T_ref_cur.translation() - kMoved.translation()).norm(), 0.02);
  EXPECT_LT(std::abs(wrapAngle(result.T_ref_cur.phi_rad - kMoved.phi_rad)), degToRad(0.5));
}

TEST_F(WideSearchAmongBoxes, IsNotMadeNearTheGuess)
{
  EXPECT_FALSE(match(SearchScope::NearGuess).usable());
}
}  // namespace psmks
