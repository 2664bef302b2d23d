/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/GaussNewton.h>
#include <psmks/joint/LinePairing.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
const PairingGates kGates{0.20, degToRad(10), 0.5};

/** Two scans of the same walls and what is derived from them; the pose of the reference scan is the
 *  origin of the world. */
struct Scene
{
  Scene(const std::vector<Wall>& walls, const Pose2& T_ref_cur_true, const BeamGrid& grid)
      : T_ref_cur(T_ref_cur_true),
        referenceScan(segmentByWalls(castScan(walls, {}, grid), walls, {})),
        currentScan(segmentByWalls(castScan(walls, T_ref_cur, grid), walls, T_ref_cur))
  {
    reference.build(referenceScan);
    current.build(currentScan);
  }

  int pair(const Pose2& guess, JointProblem& problem) const
  {
    return associateFeatures(reference, current, guess, kGates, problem);
  }

  Pose2 T_ref_cur;
  SegmentedScan referenceScan, currentScan;
  ScanFeatures reference, current;
};

/** Every pair fits where the scans truly stand: it is of one wall. */
void expectAllOfOneWall(const JointProblem& problem, const Pose2& T_ref_cur)
{
  for (const LinePairTerm& term : problem.linePairs)
  {
    const LinePairResidual r = residual(term, T_ref_cur);
    EXPECT_NEAR(r.e[0], 0, 1e-6);
    EXPECT_NEAR(r.e[1], 0, 1e-6);
  }
}
}  // namespace

//   +--------------+
//   |   o    x     |    each of the four walls pairs with itself, and with nothing else
//   +--------------+
TEST(LinePairing, EveryWallPairsWithItself)
{
  for (const int fieldOfView_deg : {180, 270, 360})
  {
    // up to 270 degrees the reference does not see the wall behind
    const Scene scene(squareRoom(), {0.4, -0.3, 0.25},
                      BeamGrid::centered(degToRad(fieldOfView_deg), fieldOfView_deg + 1));
    JointProblem problem;
    const int associations = scene.pair(scene.T_ref_cur, problem);
    EXPECT_EQ(problem.linePairs.size(), fieldOfView_deg == 360 ? 4u : 3u);
    EXPECT_GT(associations, 0.8 * fieldOfView_deg);
    expectAllOfOneWall(problem, scene.T_ref_cur);
  }
}

TEST(LinePairing, AGuessWithinTheGatesFindsTheSamePairs)
{
  const Scene scene(squareRoom(), {0.4, -0.3, 0.25}, BeamGrid::centered(2 * kPi, 360));
  JointProblem problem;
  scene.pair({0.47, -0.22, 0.25 + degToRad(1)}, problem);
  EXPECT_EQ(problem.linePairs.size(), 4u);
  expectAllOfOneWall(problem, scene.T_ref_cur);
}

TEST(LinePairing, NothingPairsBeyondTheGates)
{
  const Scene scene({{{3, -2}, {3, 2}}}, {}, BeamGrid::centered(kPi, 181));
  for (const Pose2& guess : {Pose2{0.25, 0, 0}, Pose2{-0.25, 0, 0}, Pose2{0, 0, degToRad(12)}})
  {
    JointProblem problem;
    EXPECT_EQ(scene.pair(guess, problem), 0);
    EXPECT_TRUE(problem.linePairs.empty());
  }
}

//      | |
//   o  | |  x     a thin partition seen from both sides: the two faces are 10 cm apart and look
//      | |        away from each other
TEST(LinePairing, FacesSeenFromOppositeSidesDoNotPair)
{
  const std::vector<Wall> partition = {{{2, -2}, {2, 2}}, {{2.1, 2}, {2.1, -2}}};
  const Scene scene(partition, {4, 0, kPi}, BeamGrid::centered(kPi, 181));
  ASSERT_EQ(scene.referenceScan.segments.size(), 1u);
  ASSERT_EQ(scene.currentScan.segments.size(), 1u);
  JointProblem problem;
  EXPECT_EQ(scene.pair(scene.T_ref_cur, problem), 0);
  EXPECT_TRUE(problem.linePairs.empty());
}

//   +--------------+
//   |              |      a closed scan whose seam is in the middle of a wall, of either scan
//   |    o         |
//   +--------------+
TEST(LinePairing, TheSeamIsNoEdge)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  for (const double turn_deg : {0., 1., 90., 133., 180., -90., -179.})
  {
    const Scene scene(squareRoom(), {0.3, 0.1, degToRad(turn_deg)}, grid);
    JointProblem problem;
    const int associations = scene.pair(scene.T_ref_cur, problem);
    EXPECT_EQ(problem.linePairs.size(), 4u) << "turned by " << turn_deg << " deg";
    // A wall is shared over the rays of the reference that lie on it as the current scan sees it:
    // all 360 but one or two at either end of each wall.
    EXPECT_GE(associations, 360 - 4 * 2 * 2) << "turned by " << turn_deg << " deg";
    expectAllOfOneWall(problem, scene.T_ref_cur);
  }
}

// The covariance of a pair is that of both lines, seen at the current line's anchor: for exact
// scans of a frontal wall, twice the variance of its middle.
TEST(LinePairing, TheInformationIsThatOfBothLines)
{
  const Scene scene({{{2, -2}, {2, 2}}}, {}, BeamGrid::centered(degToRad(80), 81));
  JointProblem problem;
  scene.pair({}, problem);
  ASSERT_EQ(problem.linePairs.size(), 1u);
  const Eigen::Matrix2d information = problem.linePairs[0].information;
  const Line& line = scene.referenceScan.segments[0].line;
  EXPECT_NEAR(information(0, 0) * 2 * line.covariance(0, 0), 1, 1e-6);
  EXPECT_NEAR(information(1, 1) * 2 * line.covariance(1, 1), 1, 1e-6);
}

// A single ray takes part in both directions: of the current scan against a reference line, and the
// other way round.
TEST(LinePairing, SingleRaysPairInBothDirections)
{
  Scene scene({{{2, -2}, {2, 2}}}, {0.1, 0, 0}, BeamGrid::centered(degToRad(80), 81));
  scene.referenceScan.segmentOfRay[20] = SegmentedScan::kNoSegment;
  scene.currentScan.segmentOfRay[60] = SegmentedScan::kNoSegment;
  scene.reference.build(scene.referenceScan);
  scene.current.build(scene.currentScan);
  JointProblem problem;
  scene.pair(scene.T_ref_cur, problem);
  ASSERT_EQ(problem.rays.size(), 2u);
  EXPECT_NE(problem.rays[0].pointIsCurrent, problem.rays[1].pointIsCurrent);
  for (const RayTerm& term : problem.rays) EXPECT_NEAR(residual(term, scene.T_ref_cur).e, 0, 1e-6);
}

//     O          a pillar before a wall: in the last association it is one pair, and its rays,
//     single rays
//  -------       until then, take no further part
TEST(LinePairing, CirclesTakeTheRaysOfThePillarsTheyStandFor)
{
  std::vector<Wall> walls = {{{4, -3}, {4, 3}}};
  std::vector<Eigen::Vector2d> corners_m;
  constexpr int kCorners = 60;
  for (int i = 0; i < kCorners; ++i)
  {
    const double at_rad = 2 * kPi * i / kCorners;
    corners_m.emplace_back(2.5 + 0.3 * std::cos(at_rad), 0.3 * std::sin(at_rad));
  }
  const std::vector<Wall> pillar = outline(corners_m);
  walls.insert(walls.end(), pillar.begin(), pillar.end());
  const Scene scene(walls, {0.1, 0.1, 0.05}, BeamGrid::centered(kPi, 181));

  JointProblem before, last;
  PairingGates gates = kGates;
  associateFeatures(scene.reference, scene.current, scene.T_ref_cur, gates, before);
  gates.pairShortLinesAndCircles = true;
  associateFeatures(scene.reference, scene.current, scene.T_ref_cur, gates, last);
  EXPECT_TRUE(before.circlePairs.empty());
  EXPECT_GT(before.rays.size(), 20U);
  ASSERT_EQ(last.circlePairs.size(), 1U);
  EXPECT_LT(residual(last.circlePairs[0], scene.T_ref_cur).e.norm(), 0.005);
  EXPECT_LT(last.rays.size(), 5U);
}

// Between a start and the truth a single ray may be off by the slack; walls are known well enough
// to be compared without it.
TEST(LinePairing, TheSlackOfAStartWidensSingleRays)
{
  Scene scene({{{2, -2}, {2, 2}}}, {0.1, 0, 0}, BeamGrid::centered(degToRad(80), 81));
  scene.currentScan.segmentOfRay[60] = SegmentedScan::kNoSegment;
  scene.current.build(scene.currentScan);
  JointProblem tight, slack;
  PairingGates gates = kGates;
  associateFeatures(scene.reference, scene.current, scene.T_ref_cur, gates, tight);
  gates.unsegmentedRaySlack_m = 0.02;
  associateFeatures(scene.reference, scene.current, scene.T_ref_cur, gates, slack);
  ASSERT_EQ(tight.rays.size(), 1u);
  ASSERT_EQ(slack.rays.size(), 1u);
  const double weight = gates.singleRayWeight;
  EXPECT_NEAR(weight / slack.rays[0].information - weight / tight.rays[0].information, 0.02 * 0.02,
              1e-9);
}
}  // namespace psmks
