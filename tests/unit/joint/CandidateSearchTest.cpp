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
const Pose2 kNowhere{0.9, -0.7, degToRad(40)};

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

TEST(CandidateSearch, TheTraceHoldsThePosesThatAreKept)
{
  JointScene scene(officeRoom(), kNowhere, kAround);
  Candidates c(scene);
  c.search.searchFurther();
  ASSERT_EQ(c.trace.steps.size(), scene.buffers.refinedPoses.size());
  for (std::size_t k = 0; k < c.trace.steps.size(); ++k)
  {
    const RefinedPose& kept = scene.buffers.refinedPoses[k];
    EXPECT_TRUE(isNearly(c.trace.steps[k].T_ref_cur, kept.T_ref_cur, 0, 0));
    EXPECT_EQ(c.trace.steps[k].kept, kept.associations);
    EXPECT_GE(kept.associations, scene.options.minAssociations);
    EXPECT_LE(c.verifier.rankingScore(kept), c.verifier.rankingScore(c.search.best()));
  }
}

// ---- about the guess ----------------------------------------------------------------------------

TEST(CandidateSearch, TheMostPromisingStartIsRefinedFirstAndAConvincingPoseEndsTheSearch)
{
  JointScene scene(officeRoom(), kNowhere, kAround);
  Candidates c(scene);
  c.search.searchFurther();
  EXPECT_TRUE(isFound(c.search.best(), kNowhere));
  EXPECT_GT(scene.buffers.hypotheses.size(), 1U);
  EXPECT_EQ(c.match.result.hypotheses, 1) << "the first of them is the truth";
}

TEST(CandidateSearch, WithoutAConvincingPoseNoMoreStartsAreRefinedThanTheOptionsSay)
{
  for (const int most : {1, 3})
  {
    JointScene scene(officeRoom(), kNowhere, kAround);
    scene.options.confidentScore = 2;  // no score is
    scene.options.refinedHypotheses = most;
    scene.measureGuess(1, 1);  // then no place along a wall is tried
    Candidates c(scene);
    c.search.searchFurther();
    EXPECT_LE(c.match.result.hypotheses, most);
    EXPECT_GE(c.match.result.hypotheses, 1);
    EXPECT_TRUE(isFound(c.search.best(), kNowhere)) << "the most promising was among them";
    EXPECT_TRUE(std::is_sorted(scene.buffers.hypotheses.begin(), scene.buffers.hypotheses.end(),
                               [](const Hypothesis& a, const Hypothesis& b)
                               { return a.score > b.score; }));
  }
}

//      .  .      scans without a line: nothing votes
//     .  o .
TEST(CandidateSearch, WhereNothingVotesTheGuessIsRefined)
{
  const std::vector<Wall> nothing;
  JointScene scene(nothing, {}, kAround);
  Candidates c(scene);
  c.search.searchFurther();
  EXPECT_EQ(c.match.result.hypotheses, 1);
  EXPECT_EQ(c.search.best().score, -1);
}

//  ------------.  .------------------.  .-----   y = 1     a corridor with two niches, 0.9 m wide
//              '--'    o ->  ->  o   '--'                  and 0.5 m deep; the scanner goes 3 m
//              from
//  -------------------------------------------   y = -1    o to o
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

TEST_F(CandidateSearchAlongACorridor, PlacesAlongAreTriedBeyondTheSearchAboutTheGuess)
{
  ASSERT_GT(kMoved_m, scene_.options.searchRadius_m);
  Candidates c(scene_);
  c.search.searchFurther();
  EXPECT_TRUE(isFound(c.search.best(), {kMoved_m, 0, 0}));
}

TEST_F(CandidateSearchAlongACorridor, WithoutTheWideSearchPlacesAlongAreNear)
{
  scene_.options.wideRadius_m = 0;
  Candidates c(scene_);
  c.search.searchFurther();
  ASSERT_FALSE(scene_.buffers.refinedPoses.empty());
  // From a start within the radius, that far along again, and what the gates let it move.
  const double reach_m = 2 * scene_.options.searchRadius_m + scene_.options.distanceGate_m;
  for (const RefinedPose& pose : scene_.buffers.refinedPoses)
    EXPECT_LT(std::abs(pose.T_ref_cur.x_m), reach_m);
}

// Where the guess was measured it tells the place along the walls.
TEST_F(CandidateSearchAlongACorridor, AMeasuredGuessIsNotLeftAlongTheWalls)
{
  scene_.measureGuess(0.1, degToRad(2));
  Candidates c(scene_);
  c.search.searchFurther();
  for (const RefinedPose& pose : scene_.buffers.refinedPoses)
    EXPECT_LT(std::abs(pose.T_ref_cur.x_m), scene_.options.searchRadius_m + 0.2);
}

// ---- far from the guess -------------------------------------------------------------------------

TEST(CandidateSearch, FarFromAGuessThatNobodyMeasuredThePoseIsFound)
{
  const Pose2 far{1.4, 1.7, degToRad(75)};
  JointScene scene(officeRoom(), far, kAround);
  Candidates c(scene);
  c.search.searchWide();
  EXPECT_TRUE(isFound(c.search.best(), far));
}

//  +--------------+      A square room with a chest of a given width in one corner. The scanner has
//  |              |      turned by 90 degrees. At the guess, that it has not, all walls fit and the
//  |      o       |      chest does not.
//  | []           |
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
   *  @param[out] gain_ by which the truth scores more than the guess */
  double headingFound_deg(double chest_m)
  {
    JointScene scene(roomWithChest(chest_m), {0, 0, kPi / 2}, kAround);
    Candidates c(scene);
    c.search.refineAndKeep({0, 0, kPi / 2});
    const double truth = c.search.best().score;
    Candidates again(scene);
    again.search.refineAndKeep({});
    EXPECT_TRUE(again.verifier.isAcceptable(again.search.best()));
    gain_ = truth - again.search.best().score;
    again.search.searchWide();
    return radToDeg(again.search.best().T_ref_cur.phi_rad);
  }

  double gain_ = 0;
};

// Rooms look alike from many sides: 5 rays in 100 more are no reason to leave an acceptable pose.
TEST_F(CandidateSearchInASquare, AnAcceptablePoseStaysThatAPoseFarAwayHardlyBeats)
{
  EXPECT_NEAR(headingFound_deg(0.5), 0, 0.5);
  EXPECT_GT(gain_, 0.01);
  EXPECT_LT(gain_, 0.08);
}

TEST_F(CandidateSearchInASquare, AnAcceptablePoseIsLeftForOneThatExplainsManyMoreRays)
{
  EXPECT_NEAR(headingFound_deg(1.6), 90, 0.5);
  EXPECT_GT(gain_, 0.12);
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
}

// Two rooms that have nothing in common but right angles.
TEST(CandidateSearch, AMeasuredGuessIsNotGivenUpForADoubtfulPose)
{
  const std::vector<Wall> other = box({1.3, 0.4}, 2.1, 1.7, 0.6);
  JointScene scene(segmentByWalls(castScan(officeRoom(), {}, kAround), officeRoom(), {}),
                   segmentByWalls(castScan(other, {}, kAround), other, {}));
  scene.measureGuess(0.03, degToRad(2));
  Candidates c(scene);
  c.search.searchWide();
  EXPECT_FALSE(c.verifier.isAcceptable(c.search.best()));
  EXPECT_LE(c.search.best().T_ref_cur.translation().norm(), 0.3)
      << "nothing far from the guess is kept";
}

// The guess was measured with 15 cm and 12 degrees: nothing is tried beyond three times that.
TEST(CandidateSearch, AboutAMeasuredGuessIsSearchedAsFarAsItMayBeOff)
{
  const Pose2 within{0.15, 0.1, degToRad(20)};
  JointScene scene(officeRoom(), within, kAround);
  scene.measureGuess(0.15, degToRad(12));
  Candidates c(scene);
  c.search.searchWide();
  EXPECT_TRUE(isFound(c.search.best(), within));
  for (const RefinedPose& pose : scene.buffers.refinedPoses)
  {
    // and what a start of the grid and the gates let it move: 0.5 m to either side, 10 degrees
    EXPECT_LT(pose.T_ref_cur.translation().norm(), 3 * 0.15 + 0.5 * std::sqrt(2) + 0.2);
    EXPECT_LT(std::abs(pose.T_ref_cur.phi_rad), degToRad(3 * 12 + 6 + 10));
  }
}

TEST(CandidateSearch, WhatIsReservedIsEnoughForTheWidestSearch)
{
  JointScene scene(officeRoom(), {1.4, 1.7, degToRad(75)}, kAround);
  Candidates c(scene);
  c.search.reserve();
  const Hypothesis* memory = scene.buffers.hypotheses.data();
  c.search.searchFurther();
  c.search.searchWide();
  c.search.probeAlternatives();
  EXPECT_EQ(scene.buffers.hypotheses.data(), memory);
}

// ---- alternatives -------------------------------------------------------------------------------

TEST(CandidateSearch, StartsBesideAPoseThatIsFixedComeBackToIt)
{
  const Pose2 truth{0.2, 0.1, degToRad(5)};
  JointScene scene(officeRoom(), truth, kAround);
  Candidates c(scene);
  c.search.refineAndKeep(truth);
  c.search.probeAlternatives();
  EXPECT_GE(c.match.result.hypotheses, 3) << "the pose, and a start to either side";
  EXPECT_TRUE(isFound(c.search.best(), truth));
  for (const RefinedPose& pose : scene.buffers.refinedPoses)
    EXPECT_TRUE(pose.score < c.search.best().score - 0.05 || isFound(pose, truth));
}

//   .--.     .--.     .--.     .--.        A corridor with a niche every 0.8 m: along it there are
// --'  '-----'  '-----'  '-----'  '--      many places that explain the scans as well, the nearest
//               o                          one niche away.
// -----------------------------------
TEST(CandidateSearch, OtherPlacesThatExplainAsMuchAreLeftAsRivals)
{
  constexpr double kPeriod_m = 0.8;
  std::vector<Eigen::Vector2d> corners_m{{-40, -1}, {40, -1}, {40, 1}};
  for (int k = 40; k >= -40; --k)
  {
    const double left_m = kPeriod_m * k - 0.2, right_m = left_m + 0.4;
    corners_m.insert(corners_m.end(), {{right_m, 1}, {right_m, 1.4}, {left_m, 1.4}, {left_m, 1}});
  }
  corners_m.push_back({-40, 1});
  JointScene scene(outline(corners_m), {}, BeamGrid::centered(2 * kPi, 720), 6);
  Candidates c(scene);
  c.search.refineAndKeep({});
  ASSERT_TRUE(isFound(c.search.best(), {}));
  c.search.probeAlternatives();
  EXPECT_TRUE(c.isKept({kPeriod_m, 0, 0}, 0.02, degToRad(0.2)) ||
              c.isKept({-kPeriod_m, 0, 0}, 0.02, degToRad(0.2)));
}
}  // namespace psmks
