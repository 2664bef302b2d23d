/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/ChiSquared.h>
#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>
#include <tests/unit/joint/JointScene.h>

namespace psmks
{
namespace
{
// Scans of 100 rays with a sigma of 1 cm. The poses are made by hand: of the scans only the number
// of rays and their noise matter here.
class PoseVerifierTest : public testing::Test
{
 protected:
  static constexpr int kRays = 100;
  static constexpr double kSigma_m = 0.01;

  /** A pose of which nothing is amiss: 95 of 100 rays lie on surfaces, 90 of them are associated
   * with lines that fix the position to a millimetre. */
  static RefinedPose good()
  {
    RefinedPose pose;
    pose.score = 0.95;
    pose.inlierRays = 95;
    pose.associations = 90;
    pose.converged = true;
    pose.observability.weakSigma_m = 0.001;
    pose.observability.headingSigma_rad = degToRad(0.1);
    pose.angleVariance_rad2 = std::pow(degToRad(0.05), 2);
    return pose;
  }

  RefinedPose good_ = good();
  JointScene scene_{squareRoom(), {}, BeamGrid::centered(2 * kPi, kRays)};
};

/** A good pose with one thing changed. */
template <class Change>
RefinedPose with(RefinedPose pose, const Change& change)
{
  change(pose);
  return pose;
}

RefinedPose withScore(RefinedPose pose, double score)
{
  pose.score = score;
  return pose;
}

constexpr double kALittle = 1e-6;
}  // namespace

TEST_F(PoseVerifierTest, APoseConvincesThatHasSettledWithAHighScore)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const double confident = scene_.options.confidentScore;
  EXPECT_TRUE(verifier.isConvincing(good_));
  EXPECT_TRUE(verifier.isConvincing(withScore(good_, confident)));
  EXPECT_FALSE(verifier.isConvincing(withScore(good_, confident - kALittle)));
  EXPECT_FALSE(verifier.isConvincing(with(good_, [](RefinedPose& p) { p.converged = false; })));
}

// Half of the rays on surfaces have to be associated: 48 of 95.
TEST_F(PoseVerifierTest, APoseConvincesThatIsHeldByLines)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const RefinedPose held = with(good_, [](RefinedPose& p) { p.associations = 48; });
  const RefinedPose loose = with(good_, [](RefinedPose& p) { p.associations = 47; });
  EXPECT_TRUE(verifier.isHeldByLines(held));
  EXPECT_FALSE(verifier.isHeldByLines(loose));
  EXPECT_TRUE(verifier.isConvincing(held));
  EXPECT_FALSE(verifier.isConvincing(loose));
}

// Where few rays fix the place along a wall another place may fit as well, whatever the score.
// Along a bare corridor no ray fixes it: the guess is kept there, and nothing is to be found unless
// something is left to explain.
TEST_F(PoseVerifierTest, APoseThatFewRaysHoldConvincesNobodyUnlessNoneDoes)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const auto heldTo = [&](double sigma_m, double score)
  {
    return with(withScore(good_, score),
                [&](RefinedPose& p) { p.observability.weakSigma_m = sigma_m; });
  };
  const double weak_m = 0.5 * kSigma_m, open_m = match.unobservableSigma_m();
  ASSERT_LT(weak_m, open_m);
  EXPECT_TRUE(verifier.isConvincing(heldTo(weak_m, 0.9))) << "firm";
  EXPECT_FALSE(verifier.isConvincing(heldTo(weak_m + kALittle, 1)));
  EXPECT_FALSE(verifier.isConvincing(heldTo(open_m, 1)));
  EXPECT_TRUE(verifier.isConvincing(heldTo(open_m + kALittle, 0.95)));
  EXPECT_FALSE(verifier.isConvincing(heldTo(open_m + kALittle, 0.95 - kALittle)));
}

TEST_F(PoseVerifierTest, APoseIsAcceptedFromTheAcceptanceScoreOn)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const double accept = scene_.options.acceptScore;
  EXPECT_TRUE(verifier.isAcceptable(withScore(good_, accept)));
  EXPECT_FALSE(verifier.isAcceptable(withScore(good_, accept - kALittle)));
  EXPECT_FALSE(verifier.isAcceptable(RefinedPose{})) << "a start of which nothing came";
}

// 35 of 100 rays that are paired are few, 36 are not.
TEST_F(PoseVerifierTest, DoubtfulIsWhatFewRaysAndFewPairsExplain)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const auto isDoubtful = [&](double score, int associations)
  {
    return verifier.isDoubtful(
        with(withScore(good_, score), [&](RefinedPose& p) { p.associations = associations; }));
  };
  EXPECT_TRUE(isDoubtful(0.7 - kALittle, 35));
  EXPECT_FALSE(isDoubtful(0.7 + kALittle, 35)) << "most rays are explained";
  EXPECT_FALSE(isDoubtful(0.7 - kALittle, 36)) << "many rays are paired";
  EXPECT_TRUE(isDoubtful(scene_.options.acceptScore - kALittle, 90)) << "not acceptable";
}

TEST_F(PoseVerifierTest, DoubtfulIsAPoseThatMoreSpeaksAgainstThanForHoweverManyPairsItHas)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  ASSERT_LT(scene_.options.acceptScore, 0.49) << "or it is the acceptance that decides";
  EXPECT_TRUE(verifier.isDoubtful(withScore(good_, 0.5 - kALittle)));
  EXPECT_FALSE(verifier.isDoubtful(withScore(good_, 0.5 + kALittle)));
}

//   |  \ | /  |     beyond the middle of the walls the scanner sees nothing: 30 pairs are most of
//   the |   \|/   |     returns, but few rays, and another wall may look like that
TEST_F(PoseVerifierTest, PairsOfAScanWithFewReturnsAreFewAllTheSame)
{
  constexpr double kMaxRange_m = 3.3;  // the walls are 3 m away
  JointScene shortSighted(squareRoom(), {}, BeamGrid::centered(2 * kPi, kRays), kMaxRange_m);
  const JointMatch match = shortSighted.match();
  const int returns = match.buffers.current.scan->validRays();
  ASSERT_GT(returns, 35);
  ASSERT_LT(returns, 70);
  const PoseVerifier verifier(match);
  const auto pairs = [&](int associations)
  {
    return with(good_,
                [&](RefinedPose& p)
                {
                  p.associations = associations;
                  p.inlierRays = associations;
                });
  };
  EXPECT_FALSE(verifier.isBeyondDoubt(pairs(35)));
  EXPECT_TRUE(verifier.isBeyondDoubt(pairs(36)));
}

TEST_F(PoseVerifierTest, BeyondDoubtIsWhatManyRaysAndManyPairsExplain)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  EXPECT_TRUE(verifier.isBeyondDoubt(good_));
  EXPECT_TRUE(verifier.isBeyondDoubt(withScore(good_, 0.7 + kALittle)));
  EXPECT_FALSE(verifier.isBeyondDoubt(withScore(good_, 0.7 - kALittle)));
  const auto pairs = [&](int associations)
  {
    return with(good_,
                [&](RefinedPose& p)
                {
                  p.associations = associations;
                  p.inlierRays = 40;
                });
  };
  EXPECT_FALSE(verifier.isBeyondDoubt(pairs(35)));
  EXPECT_TRUE(verifier.isBeyondDoubt(pairs(36)));
  const RefinedPose loose = with(good_, [](RefinedPose& p) { p.associations = 40; });
  EXPECT_FALSE(verifier.isBeyondDoubt(loose)) << "40 pairs do not hold 95 rays";
}

// A ray of either scan on a wall ahead tells the distance to sqrt(2) sigma, n such pairs to
// sqrt(2 / n) sigma. Seven are few, nine are not.
TEST_F(PoseVerifierTest, AFewRaysHoldADirectionWeakly)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  ASSERT_EQ(match.rangeSigma_m, kSigma_m);
  const auto heldByPairs = [&](int pairs)
  {
    return with(good_, [&](RefinedPose& p)
                { p.observability.weakSigma_m = std::sqrt(2.0 / pairs) * kSigma_m; });
  };
  EXPECT_TRUE(verifier.isWeaklyHeld(heldByPairs(7)));
  EXPECT_FALSE(verifier.isWeaklyHeld(heldByPairs(9)));
}

// A pair of walls of 2 m that 60 rays with 1 cm of noise see is known to sqrt(2) sqrt(12 / 60) 1 cm
// / 2 m = 0.2 degrees; a pair of pieces of 50 cm of a round wall to four times as much with as many
// rays.
TEST_F(PoseVerifierTest, ShortPiecesKnowTheDirectionOfNoWall)
{
  const JointMatch match = scene_.match();
  const PoseVerifier verifier(match);
  const auto ofLength = [&](double length_m)
  {
    const double sigma_rad = std::sqrt(2 * 12 / 60.0) * kSigma_m / length_m;
    return with(good_, [&](RefinedPose& p) { p.angleVariance_rad2 = sigma_rad * sigma_rad; });
  };
  EXPECT_FALSE(verifier.hasFewStraightLines(ofLength(2)));
  EXPECT_TRUE(verifier.hasFewStraightLines(ofLength(0.5)));
}

// ---- with a measured guess ----------------------------------------------------------------------

namespace
{
/** What is said of a pose that the scans know to a millimetre or two, and that lies so many
 * standard deviations of a guess, of 5 cm and 2 degrees, away from that guess in one coordinate. */
struct VerdictAwayFromGuess
{
  VerdictAwayFromGuess(double sigmas, int coordinate)
  {
    constexpr double kGuessSigma_m = 0.05, kGuessSigma_rad = degToRad(2);
    Pose2 truth;
    if (coordinate == 0) truth.x_m = sigmas * kGuessSigma_m;
    if (coordinate == 1) truth.y_m = -sigmas * kGuessSigma_m;
    if (coordinate == 2) truth.phi_rad = sigmas * kGuessSigma_rad;
    JointScene scene(officeRoom(), truth, BeamGrid::centered(2 * kPi, 720));
    scene.measureGuess(kGuessSigma_m, kGuessSigma_rad);
    JointMatch match = scene.match();
    const RefinedPose pose = Refinement(match).refine(truth);
    EXPECT_LT(pose.observability.weakSigma_m, 0.002);
    const PoseVerifier verifier(match);
    const JointOptions& o = scene.options;
    convincesWithLess = verifier.isConvincing(withScore(pose, o.agreedScore));
    convincesWithLessYet = verifier.isConvincing(withScore(pose, o.agreedScore - kALittle));
    convinces = verifier.isConvincing(withScore(pose, o.confidentScore));
    isAcceptedAtHalf = verifier.isAcceptable(withScore(pose, o.acceptScore / 2));
    isAcceptedBelowHalf = verifier.isAcceptable(withScore(pose, o.acceptScore / 2 - kALittle));
    isAcceptedBelowLimit = verifier.isAcceptable(withScore(pose, o.acceptScore - kALittle));
    isAcceptedAtTheLimit = verifier.isAcceptable(withScore(pose, o.acceptScore));
    isAcceptedWithMore = verifier.isAcceptable(withScore(pose, o.acceptScore + 0.15));
    isAccepted = verifier.isAcceptable(withScore(pose, o.acceptScore + 0.15 - kALittle));
  }

  bool convinces, convincesWithLess, convincesWithLessYet;
  bool isAcceptedAtHalf, isAcceptedBelowHalf, isAcceptedBelowLimit;
  bool isAcceptedAtTheLimit, isAccepted, isAcceptedWithMore;
};

/** The scans' own sigma widens the ellipsoids of the guess by (2 mm / 5 cm)^2 / 2 = 0.1 %, and a
 * pose is pulled by as much. */
constexpr double kInside = 0.99, kOutside = 1.01;  // of a limit
}  // namespace

// The 95 % ellipsoid reaches to 2.8 standard deviations. Within it half of the accepted score is
// enough; where the guess neither agrees nor contradicts, all of it is needed.
TEST(PoseVerifierWithGuess, APoseThatAgreesWithTheGuessIsAcceptedWithHalfTheScore)
{
  const double limit = std::sqrt(kChi2At95With3Dof);
  for (const int coordinate : {0, 1, 2})
  {
    const VerdictAwayFromGuess inside(kInside * limit, coordinate);
    EXPECT_TRUE(inside.isAcceptedAtHalf) << coordinate;
    EXPECT_FALSE(inside.isAcceptedBelowHalf) << coordinate;
    const VerdictAwayFromGuess outside(kOutside * limit, coordinate);
    EXPECT_FALSE(outside.isAcceptedBelowLimit) << coordinate;
    EXPECT_TRUE(outside.isAcceptedAtTheLimit) << coordinate;
  }
}

// The 95 % ellipsoid reaches to 2.8 standard deviations. Within, the guess is a second witness.
TEST(PoseVerifierWithGuess, APoseThatAgreesWithTheGuessConvincesWithLess)
{
  const double limit = std::sqrt(kChi2At95With3Dof);
  for (const int coordinate : {0, 1, 2})
  {
    const VerdictAwayFromGuess inside(kInside * limit, coordinate);
    EXPECT_TRUE(inside.convincesWithLess) << coordinate;
    EXPECT_FALSE(inside.convincesWithLessYet) << coordinate;
    const VerdictAwayFromGuess outside(kOutside * limit, coordinate);
    EXPECT_FALSE(outside.convincesWithLess) << coordinate;
    EXPECT_TRUE(outside.convinces) << coordinate;
  }
}

// The 99.9 % ellipsoid reaches to 4 standard deviations. What contradicts has to score 0.15 more.
TEST(PoseVerifierWithGuess, APoseThatContradictsTheGuessNeedsMoreToBeAccepted)
{
  const double limit = std::sqrt(kChi2At999With3Dof);
  for (const int coordinate : {0, 1, 2})
  {
    EXPECT_TRUE(VerdictAwayFromGuess(kInside * limit, coordinate).isAcceptedAtTheLimit);
    const VerdictAwayFromGuess outside(kOutside * limit, coordinate);
    EXPECT_FALSE(outside.isAcceptedAtTheLimit) << coordinate;
    EXPECT_FALSE(outside.isAccepted) << coordinate;
    EXPECT_TRUE(outside.isAcceptedWithMore) << coordinate;
  }
}

TEST_F(PoseVerifierTest, AMeasuredGuessTellsThePlaceAlongAWall)
{
  const RefinedPose sliding = with(good_,
                                   [](RefinedPose& p)
                                   {
                                     p.observability.weakSigma_m = 0.5;
                                     p.score = 0.9;
                                   });
  const JointMatch start = scene_.match();
  EXPECT_FALSE(PoseVerifier(start).isConvincing(sliding));
  scene_.measureGuess(0.05, degToRad(2));
  const JointMatch measured = scene_.match();
  EXPECT_TRUE(PoseVerifier(measured).isConvincing(sliding));
}
}  // namespace psmks
