/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/CandidateSearch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>

namespace psmks
{
namespace
{
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 360);
const Pose2 kOff{0.9, -0.7, degToRad(40)};  // within the search near the guess
const Pose2 kFar{1.4, 1.7, degToRad(75)};   // beyond it

/** The steps of a joint match over a scene, up to the search of candidates. */
class Candidates
{
 public:
  explicit Candidates(JointScene& scene)
      : buffers_(scene.buffers),
        match(scene.match(&trace)),
        verifier(match),
        refinement_(match),
        search(match, verifier, refinement_)
  {
    buffers_.refinedPoses.clear();
  }

  bool isKept(const Pose2& T, double tol_m, double tol_rad) const
  {
    return std::any_of(buffers_.refinedPoses.begin(), buffers_.refinedPoses.end(),
                       [&](const RefinedPose& pose)
                       { return isNearly(pose.T_ref_cur, T, tol_m, tol_rad); });
  }

 private:
  JointBuffers& buffers_;

 public:
  MatchTrace trace;
  JointMatch match;
  const PoseVerifier verifier;

 private:
  Refinement refinement_;

 public:
  CandidateSearch search;
};

/** The starts that a search proposed lie within so much about the guess, which is zero. */
void expectWithin(const std::vector<Hypothesis>& starts, double radius_m, double angle_rad)
{
  EXPECT_FALSE(starts.empty());
  for (const Hypothesis& start : starts)
  {
    EXPECT_LE(start.T_ref_cur.translation().cwiseAbs().maxCoeff(), radius_m + 1e-9);
    EXPECT_LE(std::abs(start.T_ref_cur.phi_rad), angle_rad + 1e-9);
  }
}

/** Exact scans: a pose that was refined is off by rounding and the edges of segments alone. */
testing::AssertionResult isFound(const RefinedPose& best, const Pose2& truth)
{
  return isNearly(best.T_ref_cur, truth, 5e-3, degToRad(0.1));
}
}  // namespace

// ---- what is kept -------------------------------------------------------------------------------

TEST(CandidateSearch, NothingIsBestBeforeAStartIsRefined)
{
  JointScene scene(officeRoom(), {}, kAround);
  const Candidates c(scene);
  EXPECT_EQ(c.search.best().score, -1);
  EXPECT_EQ(c.search.mostAssociations(), 0);
}

TEST(CandidateSearch, OfRefinedStartsTheBestIsKeptInWhateverOrderTheyCome)
{
  const Pose2 truth{0.2, 0.1, degToRad(5)};
  const Pose2 wrong{0.2, 0.1, degToRad(95)};
  for (const bool truthFirst : {true, false})
  {
    JointScene scene(officeRoom(), truth, kAround);
    Candidates c(scene);
    c.search.refineAndKeep(truthFirst ? truth : wrong);
    c.search.refineAndKeep(truthFirst ? wrong : truth);
    EXPECT_TRUE(isFound(c.search.best(), truth));
    EXPECT_EQ(c.match.result.hypotheses, 2);
    EXPECT_TRUE(c.isKept(truth, 0.01, degToRad(0.1)));
  }
}

// Nothing of a start outside the room is associated.
TEST(CandidateSearch, AStartWithoutAssociationsIsCountedAndNotKept)
{
  JointScene scene(officeRoom(), {}, kAround);
  Candidates c(scene);
  c.search.refineAndKeep({40, 40, 0});
  EXPECT_EQ(c.match.result.hypotheses, 1);
  EXPECT_EQ(c.search.best().score, -1);
  EXPECT_TRUE(scene.buffers.refinedPoses.empty());
  EXPECT_TRUE(c.trace.steps.empty());
}

TEST(CandidateSearch, MostAssociationsAreOfAnyStart)
{
  JointScene scene(officeRoom(), {}, kAround);
  Candidates c(scene);
  c.search.refineAndKeep({});
  const int atTruth = c.search.mostAssociations();
  EXPECT_EQ(atTruth, c.search.best().associations);
  EXPECT_GT(atTruth, 250) << "of 360 rays";
  c.search.refineAndKeep({40, 40, 0});
  EXPECT_EQ(c.search.mostAssociations(), atTruth);
}

//  +-------+
//  |   o   |   a scanner in the middle of a square room: at four headings it sees the same
//  +-------+
class CandidateSearchInASquareRoom : public testing::Test
{
 protected:
  static Pose2 turned(double heading_deg) { return {0, 0, degToRad(heading_deg)}; }

  JointScene scene_{squareRoom(), {}, kAround};
};

// What the rays say of both is the same; the prior decides, of a guess that nobody measured, too.
TEST_F(CandidateSearchInASquareRoom, TheLikelierOfTwoThatExplainAsMuchIsTheNearerToTheGuess)
{
  for (const double guess_deg : {40.0, 50.0})
    for (const bool zeroFirst : {true, false})
    {
      scene_.guess.T_ref_cur = turned(guess_deg);
      Candidates c(scene_);
      c.search.refineAndKeep(turned(zeroFirst ? 0 : 90));
      c.search.refineAndKeep(turned(zeroFirst ? 90 : 0));
      ASSERT_EQ(scene_.buffers.refinedPoses.size(), 2U);
      ASSERT_EQ(scene_.buffers.refinedPoses[0].score, scene_.buffers.refinedPoses[1].score);
      EXPECT_TRUE(isFound(c.search.best(), turned(guess_deg < 45 ? 0 : 90)));
    }
}

TEST_F(CandidateSearchInASquareRoom, OtherPosesThatExplainAsMuchAreLeftAsRivals)
{
  scene_.options.confidentScore = 2;  // no score is
  Candidates c(scene_);
  c.search.searchWide();
  for (const double heading_deg : {-90, 0, 90})
    EXPECT_TRUE(c.isKept(turned(heading_deg), 0.005, degToRad(0.1))) << heading_deg;
  for (const RefinedPose& pose : scene_.buffers.refinedPoses)
    EXPECT_LE(pose.logPosterior, c.search.best().logPosterior);
  EXPECT_TRUE(isFound(c.search.best(), {}));
}

// Without a convincing pose as many starts are refined as the options say, of the wide window twice
// as many.
TEST_F(CandidateSearchInASquareRoom, NoMoreStartsAreRefinedThanTheOptionsSay)
{
  scene_.options.confidentScore = 2;  // no score is
  scene_.options.searchAngle_rad = scene_.options.wideAngle_rad = degToRad(120);
  scene_.options.refinedHypotheses = 1;
  Candidates near(scene_);
  near.search.searchNear();
  EXPECT_EQ(near.match.result.hypotheses, 1);
  Candidates wide(scene_);
  wide.search.searchWide();
  EXPECT_EQ(wide.match.result.hypotheses, 2);
}

TEST_F(CandidateSearchInASquareRoom, AConvincingPoseEndsTheSearch)
{
  Candidates near(scene_), wide(scene_);
  near.search.searchNear();
  EXPECT_EQ(near.match.result.hypotheses, 1);
  wide.search.searchWide();
  EXPECT_GT(scene_.buffers.hypotheses.size(), 1U);
  EXPECT_EQ(wide.match.result.hypotheses, 1) << "of several";
}

TEST_F(CandidateSearchInASquareRoom, TheTraceHoldsThePosesThatAreKept)
{
  scene_.options.confidentScore = 2;  // no score is
  Candidates c(scene_);
  c.search.searchWide();
  EXPECT_GT(c.trace.steps.size(), 2U);
  ASSERT_EQ(c.trace.steps.size(), scene_.buffers.refinedPoses.size());
  for (std::size_t k = 0; k < c.trace.steps.size(); ++k)
  {
    const RefinedPose& kept = scene_.buffers.refinedPoses[k];
    EXPECT_TRUE(isNearly(c.trace.steps[k].T_ref_cur, kept.T_ref_cur, 0, 0));
    EXPECT_EQ(c.trace.steps[k].kept, kept.associations);
    EXPECT_EQ(c.trace.steps[k].score, kept.score);
    EXPECT_GE(kept.associations, scene_.options.minAssociations);
  }
}

// ---- about the guess ----------------------------------------------------------------------------

TEST(CandidateSearch, ThePromisingVoteIsRefinedFirstAndAConvincingPoseEndsTheSearch)
{
  JointScene scene(officeRoom(), kOff, kAround);
  Candidates c(scene);
  c.search.followVotes();
  EXPECT_TRUE(isFound(c.search.best(), kOff));
  EXPECT_GT(scene.buffers.hypotheses.size(), 1U);
  EXPECT_EQ(c.match.result.hypotheses, 1) << "the first of them is the truth";
}

TEST(CandidateSearch, TheBestOptimumNearTheGuessIsTheTruth)
{
  JointScene scene(officeRoom(), kOff, kAround);
  Candidates c(scene);
  c.search.searchNear();
  EXPECT_TRUE(isFound(c.search.best(), kOff));
  EXPECT_EQ(c.match.result.hypotheses, 1) << "the first of them";
}

TEST(CandidateSearch, WithoutAConvincingPoseNoMoreVotesAreFollowedThanTheOptionsSay)
{
  for (const int most : {1, 3})
  {
    JointScene scene(officeRoom(), kOff, kAround);
    scene.options.confidentScore = 2;  // no score is
    scene.options.refinedHypotheses = most;
    Candidates c(scene);
    c.search.followVotes();
    EXPECT_TRUE(std::is_sorted(scene.buffers.hypotheses.begin(), scene.buffers.hypotheses.end(),
                               [](const Hypothesis& a, const Hypothesis& b)
                               { return a.score > b.score; }));
    EXPECT_LE(c.match.result.hypotheses, most);
    EXPECT_GE(c.match.result.hypotheses, 1);
    EXPECT_TRUE(isFound(c.search.best(), kOff)) << "the most promising was among them";
  }
}

// Once the truth is known, votes with less than half of its rough score are left alone.
TEST(CandidateSearch, HopelessVotesAreNotRefined)
{
  JointScene scene(officeRoom(), kOff, kAround);
  scene.options.confidentScore = 2;  // no score is
  scene.options.refinedHypotheses = 100;
  Candidates c(scene);
  c.search.refineAndKeep(kOff);
  ASSERT_GT(c.search.best().score, 0.99);
  c.search.followVotes();
  const auto promising = std::count_if(
      scene.buffers.hypotheses.begin(), scene.buffers.hypotheses.end(),
      [&](const Hypothesis& vote) { return vote.score >= 0.5 * c.search.best().score; });
  EXPECT_EQ(c.match.result.hypotheses, 1 + promising);
  EXPECT_LT(static_cast<std::size_t>(promising), scene.buffers.hypotheses.size());
}

//      .  .      scans without a ray: nothing votes, nothing is found
//     .  o .
TEST(CandidateSearch, WithoutARayNoStartIsRefined)
{
  const std::vector<Wall> nothing;
  JointScene scene(nothing, {}, kAround);
  Candidates c(scene);
  c.search.followVotes();
  c.search.searchNear();
  c.search.searchWide();
  EXPECT_EQ(c.match.result.hypotheses, 0);
  EXPECT_EQ(c.search.best().score, -1);
}

TEST(CandidateSearch, NearAGuessThatNobodyMeasuredTheOptionsLimitTheWindow)
{
  JointScene scene(officeRoom(), kFar, kAround);
  Candidates c(scene);
  c.search.searchNear();
  expectWithin(scene.buffers.hypotheses, scene.options.searchRadius_m,
               scene.options.searchAngle_rad);
  EXPECT_FALSE(c.isKept(kFar, 0.1, degToRad(1)));
}

// The guess was measured with 15 cm and 12 degrees: nothing is tried beyond three times that.
TEST(CandidateSearch, NearAMeasuredGuessIsSearchedAsFarAsItMayBeOff)
{
  const Pose2 within{0.35, 0.3, degToRad(30)};
  JointScene scene(officeRoom(), within, kAround);
  scene.measureGuess(0.15, degToRad(12));
  Candidates c(scene);
  c.search.searchNear();
  EXPECT_TRUE(isFound(c.search.best(), within));
  expectWithin(scene.buffers.hypotheses, 3 * 0.15, degToRad(3 * 12));
}

TEST(CandidateSearch, NearAGuessThatWasMeasuredBadlyTheOptionsLimitTheWindow)
{
  JointScene scene(officeRoom(), kFar, kAround);
  scene.measureGuess(3, degToRad(80));
  Candidates c(scene);
  c.search.searchNear();
  expectWithin(scene.buffers.hypotheses, scene.options.searchRadius_m,
               scene.options.searchAngle_rad);
}

//  ------------.  .------------------.  .-----   y = 1     a corridor with two niches, 0.9 m wide
//              '--'    o ->  ->  o   '--'                  and 0.5 m deep; the scanner goes 3 m
//              from                                        from o to o
//  -------------------------------------------   y = -1
class CandidateSearchAlongACorridor : public testing::Test
{
 protected:
  static constexpr double kMoved_m = 3;

  static SegmentedScan scanAt(double x_m)
  {
    const std::vector<Wall> walls = outline({{-20, -1},
                                             {20, -1},
                                             {20, 1},
                                             {6.9, 1},
                                             {6.9, 1.5},
                                             {6, 1.5},
                                             {6, 1},
                                             {-0.1, 1},
                                             {-0.1, 1.5},
                                             {-1, 1.5},
                                             {-1, 1},
                                             {-20, 1}});
    const BeamGrid grid = BeamGrid::centered(2 * kPi, 720);
    const Pose2 T{x_m, 0, 0};
    return segmentByWalls(castScan(walls, T, grid, 8), walls, T);
  }

  JointScene scene_{scanAt(1), scanAt(1 + kMoved_m)};
};

TEST_F(CandidateSearchAlongACorridor, ThePlaceBeyondTheSearchNearTheGuessIsFoundFarFromIt)
{
  ASSERT_GT(kMoved_m, scene_.options.searchRadius_m);
  Candidates c(scene_);
  c.search.searchNear();
  EXPECT_FALSE(c.verifier.isConvincing(c.search.best())) << "bare walls fit, the niches do not";
  c.search.searchWide();
  EXPECT_TRUE(isFound(c.search.best(), {kMoved_m, 0, 0}));
}

// Where the guess was measured it tells the place along the walls.
TEST_F(CandidateSearchAlongACorridor, AMeasuredGuessIsNotLeftAlongTheWalls)
{
  scene_.measureGuess(0.1, degToRad(2));
  Candidates c(scene_);
  c.search.searchNear();
  for (const RefinedPose& pose : scene_.buffers.refinedPoses)
    EXPECT_LT(std::abs(pose.T_ref_cur.x_m), 3 * 0.1 + scene_.options.distanceGate_m);
}

// ---- far from the guess -------------------------------------------------------------------------

TEST(CandidateSearch, FarFromAGuessThatNobodyMeasuredThePoseIsFound)
{
  JointScene scene(officeRoom(), kFar, kAround);
  Candidates c(scene);
  c.search.searchWide();
  EXPECT_TRUE(isFound(c.search.best(), kFar));
  expectWithin(scene.buffers.hypotheses, scene.options.wideRadius_m, scene.options.wideAngle_rad);
  EXPECT_FALSE(c.match.result.guessGivenUp) << "there was no measurement to give up";
}

TEST(CandidateSearch, TheOptionsLimitTheWideWindow)
{
  JointScene scene(officeRoom(), kFar, kAround);
  scene.options.wideRadius_m = 0.7;
  scene.options.wideAngle_rad = degToRad(20);
  Candidates c(scene);
  c.search.searchWide();
  expectWithin(scene.buffers.hypotheses, 0.7, degToRad(20));
}

//  +--------------+      A square room with a chest of a given width in one corner. The scanner has
//  |              |      turned by 180 degrees. At the guess, that it has not, all walls fit and
//  the |      o       |      chest does not. 180 degrees are 6 standard deviations of a heading of
//  which | []           |      nobody says anything: 18 nat.
//  +--------------+
class CandidateSearchInASquare : public testing::Test
{
 protected:
  static std::vector<Wall> roomWithChest(double width_m)
  {
    std::vector<Wall> walls = squareRoom();
    for (const Wall& side : box({-3 + width_m / 2, -3 + width_m / 2}, width_m, width_m))
      walls.push_back(side);
    return walls;
  }

  /** The heading of what is best after the wide search, where the guess itself was refined before.
   *  @param[out] gain_ by which the rays speak more for the truth than for the guess, in nat */
  double headingFound_deg(double chest_m)
  {
    const Pose2 truth{0, 0, kPi / 2};
    JointScene scene(roomWithChest(chest_m), truth, kAround);
    scene.options.confidentScore = 2;  // no score is
    Candidates c(scene);
    c.search.refineAndKeep({});
    EXPECT_TRUE(c.verifier.isAcceptable(c.search.best()));
    const ScanScores scores = scene.scores();
    gain_ = logLikelihoodRatio(scores.allCounts(truth)) - logLikelihoodRatio(scores.allCounts({}));
    c.search.searchWide();
    EXPECT_TRUE(c.isKept(truth, 0.01, degToRad(0.2))) << "or the search decides";
    return radToDeg(c.search.best().T_ref_cur.phi_rad);
  }

  double gain_ = 0;
};

// Rooms look alike from many sides: what a small chest says is no reason to turn by 90 degrees.
TEST_F(CandidateSearchInASquare, APoseStaysThatAPoseFarAwayHardlyBeats)
{
  EXPECT_NEAR(headingFound_deg(0.3), 0, 0.5);
  EXPECT_GT(gain_, 0.5);
  EXPECT_LT(gain_, 4);
}

TEST_F(CandidateSearchInASquare, APoseIsLeftForOneForWhichTheRaysSayMuchMore)
{
  EXPECT_NEAR(headingFound_deg(0.6), 90, 0.5);
  EXPECT_GT(gain_, 5);
}

// ---- despite a measured guess -------------------------------------------------------------------

// The wheels say that the robot stood still, to 3 cm and 2 degrees; it was pushed and turned.
TEST(CandidateSearch, AMeasuredGuessThatLeavesNothingIsGivenUpForAPoseBeyondDoubt)
{
  const Pose2 pushed{0.4, 0.3, degToRad(75)};
  JointScene scene(officeRoom(), pushed, kAround);
  scene.measureGuess(0.03, degToRad(2));
  Candidates c(scene);
  c.search.searchWide();
  EXPECT_TRUE(isFound(c.search.best(), pushed));
  EXPECT_TRUE(c.verifier.isBeyondDoubt(c.search.best()));
  EXPECT_TRUE(c.match.result.guessGivenUp);
}

TEST(CandidateSearch, AMeasuredGuessThatLeavesAnAcceptablePoseIsKept)
{
  JointScene scene(officeRoom(), {}, kAround);
  scene.measureGuess(0.03, degToRad(2));
  Candidates c(scene);
  c.search.refineAndKeep({});
  c.search.searchWide();
  EXPECT_EQ(c.match.result.hypotheses, 1) << "nothing is searched";
  EXPECT_FALSE(c.match.result.guessGivenUp);
}

// Two rooms that have nothing in common but right angles.
TEST(CandidateSearch, AMeasuredGuessIsNotGivenUpForADoubtfulPose)
{
  const std::vector<Wall> other = box({1.3, 0.4}, 2.1, 1.7, 0.6);
  JointScene scene(segmentByWalls(castScan(officeRoom(), {}, kAround), officeRoom(), {}),
                   segmentByWalls(castScan(other, {}, kAround), other, {}));
  scene.measureGuess(0.03, degToRad(2));
  Candidates c(scene);
  c.search.searchNear();
  const RefinedPose near = c.search.best();
  const int most = c.search.mostAssociations();
  c.search.searchWide();
  EXPECT_FALSE(c.match.result.guessGivenUp);
  EXPECT_FALSE(c.verifier.isAcceptable(c.search.best()));
  EXPECT_TRUE(isNearly(c.search.best().T_ref_cur, near.T_ref_cur, 0, 0))
      << "nothing far from the guess is kept";
  EXPECT_EQ(c.search.mostAssociations(), most);
}

TEST(CandidateSearch, WhatIsReservedIsEnoughForTheWidestSearch)
{
  JointScene scene(officeRoom(), kFar, kAround);
  scene.options.confidentScore = 2;  // no score is
  Candidates c(scene);
  c.search.reserve();
  const Hypothesis* memory = scene.buffers.hypotheses.data();
  c.search.searchNear();
  c.search.searchWide();
  EXPECT_EQ(scene.buffers.hypotheses.data(), memory);
}
}  // namespace psmks
