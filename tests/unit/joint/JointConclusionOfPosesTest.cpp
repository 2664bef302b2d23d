/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/ChiSquared.h>
#include <psmks/joint/JointConclusion.h>
#include <psmks/segmentation/Segmentation.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 720);

/** What a match says in the end of a pose that was found, from a number of associated rays of the
 * start that had most. */
MatchResult conclusionOf(JointScene& scene, const RefinedPose& best, int mostAssociations)
{
  JointMatch match = scene.match();
  const PoseVerifier verifier(match);
  Refinement refinement(match);
  JointConclusion(match, verifier, refinement, best).conclude(mostAssociations);
  return match.result;
}

/** The same of the pose that is refined from a start. */
MatchResult conclusionFrom(JointScene& scene, const Pose2& start)
{
  JointMatch match = scene.match();
  const RefinedPose best = Refinement(match).refine(start);
  scene.buffers.refinedPoses = {best};
  return conclusionOf(scene, best, best.associations);
}

double sigmaAlong(const MatchResult& result, const Eigen::Vector2d& direction)
{
  const Eigen::Matrix2d position = result.covariance.topLeftCorner<2, 2>();
  return std::sqrt(direction.dot(position * direction));
}

// An office, and the pose that is refined from the truth: the scans know it to a millimetre or two.
class JointConclusionTest : public testing::Test
{
 protected:
  JointConclusionTest() { best_ = refined(); }

  RefinedPose refined()
  {
    JointMatch match = scene_.match();
    return Refinement(match).refine(kTruth);
  }

  MatchResult conclude() { return conclusionOf(scene_, best_, best_.associations); }

  void expectTheGuess(const MatchResult& result) const
  {
    EXPECT_FALSE(result.usable()) << result.report();
    EXPECT_TRUE(isNearly(result.T_ref_cur, scene_.guess.T_ref_cur, 0, 0));
    EXPECT_EQ(result.covariance,
              scene_.guess.covariance.value_or(MatchResult::unknownCovariance()));
    EXPECT_FALSE(result.unobservableDirection);
    EXPECT_FALSE(result.headingUnobservable);
  }

  const Pose2 kTruth{0.25, 0.15, 0.28};
  JointScene scene_{officeRoom(), kTruth, kAround};
  RefinedPose best_;
};
}  // namespace

// ---- accepted or refused ------------------------------------------------------------------------

TEST_F(JointConclusionTest, APoseThatExplainsTheScansIsAccepted)
{
  const MatchResult result = conclude();
  EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, best_.T_ref_cur, 0, 0));
  EXPECT_EQ(result.score, best_.score);
  EXPECT_EQ(result.associations, best_.associations);
  EXPECT_FALSE(result.unobservableDirection);
  EXPECT_FALSE(result.headingUnobservable);
}

TEST_F(JointConclusionTest, AnAcceptedPoseThatHasNotSettledSaysSo)
{
  best_.converged = false;
  EXPECT_EQ(conclude().status, MatchStatus::MaxIterations);
}

TEST_F(JointConclusionTest, FewerAssociationsThanTheOptionsAskForAreTooFew)
{
  const int enough = scene_.options.minAssociations;
  const MatchResult few = conclusionOf(scene_, RefinedPose{}, enough - 1);
  EXPECT_EQ(few.status, MatchStatus::TooFewAssociations);
  expectTheGuess(few);
  EXPECT_NE(conclusionOf(scene_, best_, enough).status, MatchStatus::TooFewAssociations);
}

TEST_F(JointConclusionTest, APoseBelowTheAcceptanceScoreIsRefusedAndTheGuessKept)
{
  best_.score = scene_.options.acceptScore - 0.01;
  const MatchResult result = conclude();
  EXPECT_EQ(result.status, MatchStatus::NoImprovement);
  EXPECT_EQ(result.score, best_.score) << "how near it was is told";
  expectTheGuess(result);

  scene_.measureGuess(0.1, 0.02);
  expectTheGuess(conclude());
}

// ---- how well the pose is known -----------------------------------------------------------------

// A guess that nobody measured adds nothing that counts to a pose that is known to a millimetre.
TEST_F(JointConclusionTest, TheCovarianceIsWhatTheScansKnow)
{
  const MatchResult result = conclude();
  const Observability& o = best_.observability;
  EXPECT_NEAR(sigmaAlong(result, o.weakDirection) / o.weakSigma_m, 1, 1e-3);
  EXPECT_NEAR(std::sqrt(result.covariance(2, 2)) / o.headingSigma_rad, 1, 1e-3);
}

// A guess that knows the position twice as well as the scans: together they know it better than
// either.
TEST_F(JointConclusionTest, AMeasuredGuessMakesThePoseBetterKnown)
{
  const double sigma_m = best_.observability.weakSigma_m / 2;
  const double alone_m = sigmaAlong(conclude(), best_.observability.weakDirection);
  scene_.guess.T_ref_cur = best_.T_ref_cur;
  scene_.measureGuess(sigma_m, degToRad(2));
  best_ = refined();
  const double fused_m = sigmaAlong(conclude(), best_.observability.weakDirection);
  EXPECT_LT(fused_m, sigma_m);
  EXPECT_LT(fused_m, alone_m);
  // 1 / sqrt(1 + 4) of the scans' sigma where the heading is known; it is not, which helps neither.
  EXPECT_GT(fused_m, 0.99 * alone_m / std::sqrt(5));
}

// ---- what the scans leave open ------------------------------------------------------------------

// ------------------   bare walls along 30 degrees: the guess says how far along them, the scans
//     o  x             where across
// ------------------
TEST(JointConclusionInACorridor, AlongItThePoseIsTheGuess)
{
  const Pose2 T_corridor_ref{0, 0, degToRad(-30)}, T_ref_cur{0, 0.05, 0};
  const std::vector<Wall> walls = corridor();
  const auto scanFrom = [&](const Pose2& T)
  { return segmentByWalls(castScan(walls, T, kAround, 8), walls, T); };
  JointScene scene(scanFrom(T_corridor_ref), scanFrom(T_corridor_ref * T_ref_cur));
  const Eigen::Vector2d along(std::cos(degToRad(30)), std::sin(degToRad(30)));
  const Eigen::Vector2d across(-along.y(), along.x());
  // The best pose lies 30 cm farther along than the guess.
  const Eigen::Vector2d start_m = 0.3 * along;
  for (const bool measured : {false, true})
  {
    if (measured) scene.measureGuess(0.2, degToRad(2));
    const MatchResult result = conclusionFrom(scene, {start_m.x(), start_m.y(), 0});
    EXPECT_EQ(result.status, MatchStatus::Degenerate) << result.report();
    ASSERT_TRUE(result.unobservableDirection);
    EXPECT_NEAR(std::abs(result.unobservableDirection->dot(along)), 1, 1e-3);
    EXPECT_NEAR(along.dot(result.T_ref_cur.translation()), 0, 2e-3);
    EXPECT_NEAR(across.dot(result.T_ref_cur.translation()), across.dot(T_ref_cur.translation()),
                2e-3);
    EXPECT_FALSE(result.headingUnobservable);
    // As well as the guess is known: 1 m where nobody measured, else 20 cm. 5 % are left for the
    // little that walls of finite length know.
    EXPECT_NEAR(sigmaAlong(result, along), measured ? 0.2 : 1, measured ? 0.01 : 0.05);
    EXPECT_LT(sigmaAlong(result, across), 0.005);
  }
}

//       . - ~ - .
//     .     o>    .      A scanner in a round room sees the same at every heading.
//    (             )
//     .           .
//       ` - . - '
TEST(JointConclusionInARoundRoom, TheHeadingIsTheGuess)
{
  std::vector<Eigen::Vector2d> corners_m;  // so many that no ray sees more of a side than a point
  constexpr int kSides = 2000;
  for (int k = 0; k < kSides; ++k)
  {
    const double a_rad = 2 * kPi * k / kSides;
    corners_m.push_back({5 * std::cos(a_rad), 5 * std::sin(a_rad)});
  }
  std::mt19937 rng(3);
  const auto scanFrom = [&](const Pose2& T)
  {
    SegmentationBuffers buffers;
    SegmentedScan scan;
    const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
    segmentScan(castScan(outline(corners_m), T, grid, 30, 0.01, rng), {}, {}, buffers, scan);
    return scan;
  };
  JointScene scene(scanFrom({}), scanFrom({0.1, 0.05, degToRad(10)}));
  scene.guess.T_ref_cur = {0, 0, degToRad(10)};
  const MatchResult result = conclusionFrom(scene, {0.05, 0, degToRad(9)});
  EXPECT_EQ(result.status, MatchStatus::Degenerate) << result.report();
  EXPECT_TRUE(result.headingUnobservable) << result.report();
  EXPECT_NEAR(result.T_ref_cur.phi_rad, degToRad(10), 1e-9) << result.report();
  // 360 rays with 1 cm of noise know a place to 1 mm; the arcs they are paired with, to 1 cm or so.
  EXPECT_TRUE(isNearly(result.T_ref_cur, {0.1, 0.05, degToRad(10)}, 0.02, 1e-9));
  EXPECT_GT(std::sqrt(result.covariance(2, 2)), degToRad(25)) << "30 degrees where nobody measured";
}

// ---- other poses that explain as much -----------------------------------------------------------

namespace
{
/** A pose beside the best one: so far away, and so many nat less likely. */
struct Rival
{
  Pose2 away;
  double less;
};

class JointConclusionWithRivals : public JointConclusionTest
{
 protected:
  RefinedPose rivalOf(const Rival& rival) const
  {
    RefinedPose pose = best_;
    pose.T_ref_cur.x_m += rival.away.x_m;
    pose.T_ref_cur.y_m += rival.away.y_m;
    pose.T_ref_cur.phi_rad = wrapAngle(pose.T_ref_cur.phi_rad + rival.away.phi_rad);
    pose.logPosterior -= rival.less;
    return pose;
  }

  /** The best pose among others that were refined. */
  MatchResult concludeWith(const std::vector<Rival>& rivals)
  {
    scene_.buffers.refinedPoses = {best_};
    for (const Rival& rival : rivals) scene_.buffers.refinedPoses.push_back(rivalOf(rival));
    return conclude();
  }

  void expectNoAlternative(const MatchResult& result)
  {
    EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
    EXPECT_FALSE(result.ambiguity.has_value());
    EXPECT_EQ(result.covariance, concludeWith({}).covariance);
  }

  /** What one rival adds to the covariance, by its share of the probability. */
  static Eigen::Matrix3d spread(const Rival& rival, double weight)
  {
    const Eigen::Vector3d d(rival.away.x_m, rival.away.y_m, rival.away.phi_rad);
    return weight * d * d.transpose();
  }

  const Pose2 far_{0.9, -1.2, 0};  // 1.5 m
  const Eigen::Vector2d direction_{0.6, -0.8}, across_{0.8, 0.6};
};
}  // namespace

// Which of two poses is the true one is open: the covariance reaches from one to the other.
TEST_F(JointConclusionWithRivals, ThePositionIsOpenBetweenPosesThatExplainAsMuch)
{
  const double across_m = sigmaAlong(concludeWith({}), across_);
  const MatchResult result = concludeWith({{far_, 0}});
  EXPECT_EQ(result.status, MatchStatus::Degenerate) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, best_.T_ref_cur, 0, 0)) << "neither mean nor guess";
  EXPECT_NEAR(sigmaAlong(result, direction_), 1.5 * std::sqrt(0.5), 1e-4) << "one half each";
  EXPECT_NEAR(sigmaAlong(result, across_), across_m, 1e-6) << "nothing is open across";
}

// As likely as the best, 1 nat less and 2 nat less: 1, 0.37 and 0.14 to 1.
TEST_F(JointConclusionWithRivals, WeightsAreTheProbabilitiesOfThePoses)
{
  const Rival even{far_, 0}, less{{-1, 0.5, 0}, 1}, least{{0, 2, degToRad(90)}, 2};
  const Eigen::Matrix3d alone = concludeWith({}).covariance;
  const MatchResult result = concludeWith({less, least, even});
  ASSERT_TRUE(result.ambiguity);
  const Ambiguity& ambiguity = *result.ambiguity;
  EXPECT_EQ(ambiguity.alternatives, 3);
  const double sum = 1 + 1 + std::exp(-1) + std::exp(-2);
  const Rival inOrder[] = {even, less, least};
  Eigen::Matrix3d mixture = alone;
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(ambiguity.likeliest[k].weight, std::exp(-inOrder[k].less) / sum, 1e-12) << k;
    EXPECT_TRUE(
        isNearly(ambiguity.likeliest[k].T_ref_cur, rivalOf(inOrder[k]).T_ref_cur, 0, 1e-12));
    mixture += spread(inOrder[k], std::exp(-inOrder[k].less) / sum);
  }
  EXPECT_EQ(ambiguity.likeliest[3].weight, 0) << "there is no fourth";
  EXPECT_TRUE(result.covariance.isApprox(mixture, 1e-9)) << "the second moment of the mixture";
  EXPECT_TRUE(result.ambiguousDirection()->isApprox(direction_)) << "to the likeliest";
}

// 3 nat are one in twenty.
TEST_F(JointConclusionWithRivals, APoseThatIsClearlyLessLikelyIsNoAlternative)
{
  expectNoAlternative(concludeWith({{far_, 4}}));
  expectNoAlternative(concludeWith({{far_, 3.01}}));
  const MatchResult at3 = concludeWith({{far_, 2.99}});
  ASSERT_TRUE(at3.ambiguity);
  EXPECT_NEAR(at3.ambiguity->likeliest[0].weight, 1 / (1 + std::exp(2.99)), 1e-12);
}

// A score says nothing of how much was seen.
TEST_F(JointConclusionWithRivals, TheScoreDoesNotDecideWhatIsAnAlternative)
{
  RefinedPose likely = rivalOf({far_, 0.5}), unlikely = rivalOf({far_, 6});
  likely.score = best_.score - 0.3, unlikely.score = best_.score;
  scene_.buffers.refinedPoses = {best_, likely};
  EXPECT_TRUE(conclude().ambiguity);
  scene_.buffers.refinedPoses = {best_, unlikely};
  EXPECT_FALSE(conclude().ambiguity);
}

TEST_F(JointConclusionWithRivals, APoseAtTheSamePlaceIsNoAlternative)
{
  expectNoAlternative(concludeWith({{{0.012, -0.016, 0}, 0}}));
  expectNoAlternative(concludeWith({{{0.08, 0.04, degToRad(1.9)}, 0}}));
  EXPECT_TRUE(concludeWith({{{0.08, 0.08, 0}, 0}}).ambiguity) << "more than 0.1 m away";
  EXPECT_TRUE(concludeWith({{{0, 0, degToRad(2.1)}, 0}}).ambiguity);
}

TEST_F(JointConclusionWithRivals, StartsThatEndedAtOneOptimumCountOnce)
{
  const Rival better{far_, 1}, worse{{0.92, -1.2, 0}, 2};
  const MatchResult result = concludeWith({worse, better});
  ASSERT_TRUE(result.ambiguity);
  EXPECT_EQ(result.ambiguity->alternatives, 1);
  EXPECT_NEAR(result.ambiguity->likeliest[0].weight, 1 / (1 + std::exp(1)), 1e-12);
  EXPECT_TRUE(isNearly(result.ambiguity->likeliest[0].T_ref_cur, rivalOf(better).T_ref_cur, 0, 0));
}

TEST_F(JointConclusionWithRivals, MoreThanAreListedAreCountedAndMixedIn)
{
  std::vector<Rival> rivals;
  Eigen::Matrix3d mixture = concludeWith({}).covariance;
  double sum = 1;
  for (int k = 0; k < Ambiguity::kMost + 2; ++k)
  {
    rivals.push_back({{0.5 * (k + 1), 0.2 * k, 0}, 0.4 * k});
    sum += std::exp(-0.4 * k);
  }
  for (const Rival& rival : rivals) mixture += spread(rival, std::exp(-rival.less) / sum);
  std::reverse(rivals.begin(), rivals.end());
  const MatchResult result = concludeWith(rivals);
  ASSERT_TRUE(result.ambiguity);
  EXPECT_EQ(result.ambiguity->alternatives, Ambiguity::kMost + 2);
  for (std::size_t k = 0; k < std::size_t{Ambiguity::kMost}; ++k)
    EXPECT_NEAR(result.ambiguity->likeliest[k].weight,
                std::exp(-0.4 * static_cast<double>(k)) / sum, 1e-12);
  EXPECT_TRUE(result.covariance.isApprox(mixture, 1e-9));
}

// The best pose is the guess, which was measured with 10 cm: another one 1.5 m away contradicts it.
TEST_F(JointConclusionWithRivals, APoseThatContradictsAMeasuredGuessIsNoAlternative)
{
  scene_.guess.T_ref_cur = kTruth;
  scene_.measureGuess(0.1, degToRad(2));
  best_ = refined();
  RefinedPose other = rivalOf({far_, 0});
  ASSERT_FALSE(other.innovation.isContradiction());
  scene_.buffers.refinedPoses = {best_, other};
  EXPECT_TRUE(conclude().ambiguity);
  other.innovation = {kChi2At999With3Dof + 1, 3};
  scene_.buffers.refinedPoses = {best_, other};
  EXPECT_FALSE(conclude().ambiguity);
}
}  // namespace psmks
