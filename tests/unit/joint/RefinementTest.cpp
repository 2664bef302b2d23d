/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/Refinement.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/joint/JointScene.h>

#include <cmath>

namespace psmks
{
namespace
{
const Pose2 kT_ref_cur{0.3, 0.1, degToRad(3)};
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 720);
}  // namespace

TEST(Refinement, AStartWithinTheGatesComesToTheTruth)
{
  JointScene scene(officeRoom(), kT_ref_cur, kAround);
  JointMatch match = scene.match();
  const RefinedPose pose = Refinement(match).refine({0.38, 0.03, degToRad(6)});
  EXPECT_TRUE(pose.converged);
  EXPECT_TRUE(isNearly(pose.T_ref_cur, kT_ref_cur, 1e-3, degToRad(0.02)));
  EXPECT_GT(pose.score, 0.95);
  EXPECT_LE(pose.inlierRays, 720);
  EXPECT_GT(pose.inlierRays, 0.9 * 720);
  EXPECT_GT(match.result.iterations, 0);
}

// A wall 3 m ahead, and one on the other side of it that the current scan sees: nothing in common.
TEST(Refinement, WithoutEnoughAssociationsThereIsNoScore)
{
  const std::vector<Wall> ahead{{{3, -2}, {3, 2}}};
  JointScene scene(ahead, {}, BeamGrid::centered(kPi, 181));
  JointMatch match = scene.match();
  const RefinedPose pose = Refinement(match).refine({1, 0, 0});
  EXPECT_EQ(pose.score, -1);
  EXPECT_FALSE(pose.converged);
  EXPECT_LT(pose.associations, scene.options.minAssociations);
}

// Off by 14 cm: within the gate of 20 cm. Off by 24 cm: beyond it.
TEST(Refinement, AStartBeyondTheGatesFindsNothing)
{
  JointScene scene({{{3, -2}, {3, 2}}}, {}, BeamGrid::centered(kPi, 181));
  JointMatch match = scene.match();
  Refinement refinement(match);
  EXPECT_NEAR(refinement.refine({0.14, 0, 0}).T_ref_cur.x_m, 0, 1e-3);
  EXPECT_EQ(refinement.refine({0.24, 0, 0}).score, -1);
}

// What the rays say, and the prior: that of a guess nobody measured is one of 1 m and 30 degrees.
// In a room at whose true pose all rays are on surfaces, the likelihood is that of the looks.
TEST(Refinement, TheLogPosteriorIsThatOfRaysAndPrior)
{
  const Pose2 truth{0.3, -0.2, degToRad(6)};
  JointScene scene(squareRoom(), truth, BeamGrid::centered(2 * kPi, 360));
  scene.guess.T_ref_cur = {0.1, 0.2, degToRad(-6)};
  JointMatch match = scene.match();
  const RefinedPose pose = Refinement(match).refine(truth);
  ASSERT_TRUE(isNearly(pose.T_ref_cur, truth, 1e-3, degToRad(0.02)));
  const RayCounts counts = scene.scores().allCounts(pose.T_ref_cur);
  const double prior = -0.5 * (0.2 * 0.2 + 0.4 * 0.4 + std::pow(12.0 / 30, 2));
  EXPECT_NEAR(match.logPrior(pose), prior, 2e-3);
  EXPECT_NEAR(pose.logPosterior, logLikelihoodRatio(counts) + prior, 2e-3);
  EXPECT_NEAR(pose.score, freeSpaceScore(counts), 1e-12);

  // A measured one, of 10 cm and 3 degrees: 2, 4 and 4 standard deviations away.
  scene.measureGuess(0.1, degToRad(3));
  JointMatch measured = scene.match();
  const RefinedPose held = Refinement(measured).refine(truth);
  EXPECT_NEAR(measured.logPrior(held), -0.5 * held.innovation.chi2, 1e-12);
  EXPECT_NEAR(held.innovation.chi2, 4 + 16 + 16, 0.5);
  EXPECT_NEAR(
      held.logPosterior,
      logLikelihoodRatio(scene.scores().allCounts(held.T_ref_cur)) + measured.logPrior(held), 1e-9);
}

// ------------------   Along bare walls a start stays where it is, and what is known of the place
//     o  x             there is nothing; across them it comes to the truth.
// ------------------
TEST(Refinement, AlongACorridorAStartStaysAndTheScansKnowNothing)
{
  JointScene scene(corridor(), {0, 0.05, 0}, kAround, 8);
  JointMatch match = scene.match();
  const RefinedPose pose = Refinement(match).refine({0.4, 0, 0});
  EXPECT_NEAR(pose.T_ref_cur.x_m, 0.4, 1e-3);
  EXPECT_NEAR(pose.T_ref_cur.y_m, 0.05, 1e-3);
  EXPECT_NEAR(std::abs(pose.observability.weakDirection.x()), 1, 1e-3);
  EXPECT_GT(pose.observability.weakSigma_m, 10 * match.weakDirectionSigma_m());
  EXPECT_LT(pose.observability.headingSigma_rad, degToRad(0.1));
}

// The guess takes part in the estimate, but what is known of the pose is what the scans know.
TEST(Refinement, WhatIsKnownIsOfTheScansAlone)
{
  JointScene scene(officeRoom(), kT_ref_cur, kAround);
  scene.guess.T_ref_cur = kT_ref_cur;
  JointMatch start = scene.match();
  const Observability alone = Refinement(start).refine(kT_ref_cur).observability;
  scene.measureGuess(1e-4, 1e-5);
  JointMatch measured = scene.match();
  const Observability withGuess = Refinement(measured).refine(kT_ref_cur).observability;
  EXPECT_NEAR(withGuess.weakSigma_m / alone.weakSigma_m, 1, 1e-3);
  EXPECT_NEAR(withGuess.headingSigma_rad / alone.headingSigma_rad, 1, 1e-3);
}

// The scanner moved 2 cm more than a guess that was measured with 5 cm says: by far the scans know
// better. A guess measured with 0.1 mm holds the pose.
TEST(Refinement, AMeasuredGuessTakesPartByItsCovariance)
{
  const Pose2 guess{kT_ref_cur.x_m - 0.02, kT_ref_cur.y_m, kT_ref_cur.phi_rad};
  const auto refinedWith = [&](double sigma_m)
  {
    JointScene scene(officeRoom(), kT_ref_cur, kAround);
    scene.guess.T_ref_cur = guess;
    scene.measureGuess(sigma_m, degToRad(2));
    JointMatch match = scene.match();
    return Refinement(match).refine(guess).T_ref_cur.x_m;
  };
  EXPECT_NEAR(refinedWith(0.05), kT_ref_cur.x_m, 1e-3);
  EXPECT_NEAR(refinedWith(1e-4), guess.x_m, 2e-3);
}

// Where all that is left is a round pillar, no pair of lines knows any direction.
TEST(Refinement, WithoutAPairOfLinesTheAngleIsNotKnown)
{
  std::vector<Eigen::Vector2d> corners_m;
  for (int k = 0; k < 40; ++k)
  {
    const double a_rad = 2 * kPi * k / 40;
    corners_m.push_back({2 + 0.5 * std::cos(a_rad), 0.5 * std::sin(a_rad)});
  }
  JointScene scene(outline(corners_m), {}, BeamGrid::centered(kPi, 361));
  JointMatch match = scene.match();
  const RefinedPose pose = Refinement(match).refine({});
  EXPECT_GT(pose.angleVariance_rad2, std::pow(degToRad(0.25), 2));
}

//   +--------------+       a hall of 20 x 12 m with a recess; ranges have 30 cm of noise
//   |   r c        |
//   |         +----+
//   +---------+
//
// Lines through that noise are known to 5 cm or so, as wide as the last gates are: a gate that did
// not widen with the noise would leave of them what happens to fit. How many rays can be paired at
// all is what the association finds at the true pose with gates that are wide open. By its own
// gate, of 1.5 sigma, it may lose a pair where a line is short; but for one ray in eight it must
// keep them. (Measured: 0.93 are kept.)
TEST(Refinement, KeepsTheWallsOfANoisyScan)
{
  const std::vector<Wall> hall = outline({{-6, -6}, {6, -6}, {6, 0}, {14, 0}, {14, 6}, {-6, 6}});
  constexpr double kSigma_m = 0.3;
  const BeamGrid grid = BeamGrid::centered(kPi, 361);
  int kept = 0, pairable = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    std::mt19937 rng(seed);
    const auto scanFrom = [&](const Pose2& T)
    { return segmentByWalls(castScan(hall, T, grid, 30, kSigma_m, rng), hall, T); };
    const SegmentedScan reference = scanFrom({}), current = scanFrom(kT_ref_cur);
    JointScene scene(reference, current);
    scene.guess.T_ref_cur = kT_ref_cur;
    JointMatch match = scene.match();
    kept += Refinement(match).refine(kT_ref_cur).associations;
    PairingGates open{2, degToRad(45), scene.options.singleRayWeight};
    open.pairShortLinesAndCircles = true;
    JointProblem problem;
    pairable += associateFeatures(scene.buffers.reference, scene.buffers.current, kT_ref_cur, open,
                                  problem);
  }
  EXPECT_GT(kept, 7 * pairable / 8) << pairable;
}
}  // namespace psmks
