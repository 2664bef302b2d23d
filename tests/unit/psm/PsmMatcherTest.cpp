/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/psm/PsmMatcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/psm/PsmScenes.h>

#include <Eigen/Eigenvalues>

namespace psmks
{
namespace
{
using test::drawnScan;
using test::kNothing_m;
using test::prepared;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Pose2 T_ref_cur{0.25, -0.15, degToRad(8)};

class PsmMatcherTest : public testing::Test
{
 protected:
  PsmResult match(const Scan& reference, const Scan& current, const Pose2& guess = {}) const
  {
    return PsmMatcher(options_).match(prepared(reference, options_), prepared(current, options_),
                                      guess);
  }

  /** Matches scans of the office from the origin and from T_ref_cur with 1 cm of noise. */
  PsmResult matchOffice(const BeamGrid& grid) const
  {
    std::mt19937 rng(1);
    const Scan reference = castScan(officeRoom(), {}, grid, 30, 0.01, rng);
    return match(reference, castScan(officeRoom(), T_ref_cur, grid, 30, 0.01, rng));
  }

  PsmOptions options_;
  const BeamGrid grid_ = BeamGrid::centered(kPi, 361);
};

TEST_F(PsmMatcherTest, AScanMatchesItselfWhereItIs)
{
  const Scan scan = castScan(officeRoom(), {}, grid_);
  const PsmResult result = match(scan, scan);
  EXPECT_EQ(result.status, PsmStatus::Converged);
  EXPECT_TRUE(isNearly(result.T_ref_cur, {}, 0.005, degToRad(0.1)));
  EXPECT_LT(result.errorIndex_m, 0.01);
}

TEST_F(PsmMatcherTest, AMotionIsFoundInAnyFieldOfViewAndDensity)
{
  for (const BeamGrid& grid :
       {BeamGrid::centered(kPi, 181), BeamGrid::centered(kPi, 361),
        BeamGrid::centered(degToRad(240), 682), BeamGrid::centered(degToRad(270), 1081),
        BeamGrid::centered(degToRad(120), 241), BeamGrid::centered(2 * kPi, 360),
        BeamGrid(0, degToRad(0.5), 720), BeamGrid(degToRad(-300), degToRad(1), 270)})
  {
    SCOPED_TRACE(std::to_string(grid.count()) + " rays");
    const PsmResult result = matchOffice(grid);
    EXPECT_EQ(result.status, PsmStatus::Converged);
    EXPECT_TRUE(isNearly(result.T_ref_cur, T_ref_cur, 0.02, degToRad(0.5)));
    EXPECT_GT(result.pairs, grid.count() / 2);
  }
}

/** The scan of the reflected scene, with left and right exchanged. */
Scan mirrored(Scan scan)
{
  std::reverse(scan.range_m.begin(), scan.range_m.end());
  return scan;
}

TEST_F(PsmMatcherTest, AMirroredSceneGivesTheMirroredMotion)
{
  const Scan reference = castScan(officeRoom(), {}, grid_);
  const Scan current = castScan(officeRoom(), T_ref_cur, grid_);
  const Pose2 plain = match(reference, current).T_ref_cur;
  const Pose2 mirror = match(mirrored(reference), mirrored(current)).T_ref_cur;
  EXPECT_TRUE(isNearly(mirror, {plain.x_m, -plain.y_m, -plain.phi_rad}, 1e-3, degToRad(0.02)));
}

TEST_F(PsmMatcherTest, AClosedScanMatchesWhereverItsRaysBegin)
{
  options_ = test::unfiltered();
  const Pose2 first = matchOffice(BeamGrid(-kPi, degToRad(1), 360)).T_ref_cur;
  std::mt19937 rng(1);
  const auto begunElsewhere = [&](const Pose2& pose)
  {
    const Scan scan = castScan(officeRoom(), pose, BeamGrid(-kPi, degToRad(1), 360), 30, 0.01, rng);
    Scan turned = scan;
    turned.grid = BeamGrid(-kPi + degToRad(100), degToRad(1), 360);
    std::rotate(turned.range_m.begin(), turned.range_m.begin() + 100, turned.range_m.end());
    return turned;
  };
  const Scan reference = begunElsewhere({});
  const Pose2 second = match(reference, begunElsewhere(T_ref_cur)).T_ref_cur;
  EXPECT_TRUE(isNearly(second, first, 1e-6, 1e-6));
}

TEST_F(PsmMatcherTest, TheNearestPointsMayJudgeTheMatch)
{
  const double byRanges_m = matchOffice(grid_).errorIndex_m;
  options_.errorIndex = PsmErrorIndex::NearestPoint;
  const double byPoints_m = matchOffice(grid_).errorIndex_m;
  EXPECT_NE(byPoints_m, byRanges_m);
  EXPECT_GT(byPoints_m, 0);
  EXPECT_LT(byPoints_m, 0.1);
}

TEST_F(PsmMatcherTest, IterationsEndWhereTheStepsAreSmallOrTheOptionsSay)
{
  const int usual = matchOffice(grid_).iterations;
  options_.smallStepsToStop = 1;
  EXPECT_LT(matchOffice(grid_).iterations, usual);
  options_.stopTranslation_m = options_.stopRotation_rad = 1;
  EXPECT_EQ(matchOffice(grid_).iterations, 2) << "one step of each kind";
  options_.maxIterations = 1;
  EXPECT_EQ(matchOffice(grid_).status, PsmStatus::MaxIterations);
  EXPECT_EQ(matchOffice(grid_).iterations, 1);
  EXPECT_EQ(matchOffice(grid_).T_ref_cur.translation().norm(), 0) << "orientation goes first";
  EXPECT_GT(matchOffice(grid_).T_ref_cur.phi_rad, degToRad(1));
}

// In the current scan only, a person of 0.5 m width stands in front of the wall and covers a fifth
// of it.
TEST_F(PsmMatcherTest, LateIterationsTrustPairsThatDifferLittle)
{
  const Scan reference = castScan(officeRoom(), {}, grid_);
  Scan current = reference;
  for (std::size_t i = 150; i < 200; ++i) current.range_m[i] -= 0.4;
  options_.smallStepsToStop = options_.maxIterations;
  const double sharpened_m = match(reference, current).T_ref_cur.translation().norm();
  options_.lateFromIteration = options_.maxIterations;
  const double blunt_m = match(reference, current).T_ref_cur.translation().norm();
  EXPECT_LT(sharpened_m, 0.5 * blunt_m);
}

TEST_F(PsmMatcherTest, TooSmallAnArcOfPairsIsAFailureThatKeepsTheGuess)
{
  options_.minPairedArc_rad = kPi;
  const Pose2 guess{0.2, -0.1, 0.1};
  const Scan scan = castScan(officeRoom(), {}, grid_);
  const PsmResult result = match(scan, castScan(officeRoom(), T_ref_cur, grid_), guess);
  EXPECT_EQ(result.status, PsmStatus::TooFewPairs);
  EXPECT_FALSE(result.usable());
  EXPECT_TRUE(isNearly(result.T_ref_cur, guess, 0, 0));
  EXPECT_GT(result.iterations, 0);
}

TEST_F(PsmMatcherTest, AnArcThatFixesNoPositionIsAFailure)
{
  options_.minPairedArc_rad = 0;
  const Scan beam = drawnScan({2, 2, 2, 2}, 1e-4);
  EXPECT_EQ(match(beam, beam).status, PsmStatus::Singular);
}

TEST_F(PsmMatcherTest, BadDataEndInAStatusAndAFinitePose)
{
  const Scan room = castScan(officeRoom(), {}, grid_);
  Scan misfit = room;
  misfit.range_m.pop_back();
  const std::vector<Scan> scans{Scan(),
                                room,
                                misfit,
                                drawnScan({2}),
                                drawnScan(std::vector<double>(361, kNan)),
                                drawnScan(std::vector<double>(361, kNothing_m)),
                                drawnScan(std::vector<double>(361, 1e-300)),
                                drawnScan(std::vector<double>(361, -1)),
                                drawnScan(std::vector<double>(360, 2), 2 * kPi)};
  for (const Scan& reference : scans)
    for (const Scan& current : scans)
      for (const Pose2& guess : {Pose2{}, Pose2{1e6, 0, 0}, Pose2{1e300, -1e300, 1},
                                 Pose2{kNan, 0, 0}, Pose2{0, 0, kNothing_m}})
      {
        const PsmResult result = match(reference, current, guess);
        EXPECT_NE(result.status, PsmStatus::NotRun);
        EXPECT_TRUE(result.T_ref_cur.isFinite());
        EXPECT_TRUE(result.covariance.allFinite());
        EXPECT_GT(result.covariance.eigenvalues().real().minCoeff(), 0);
      }
  EXPECT_EQ(match(Scan(), room).status, PsmStatus::InvalidInput);
  EXPECT_EQ(match(room, room, {kNan, 0, 0}).status, PsmStatus::InvalidInput);
}
}  // namespace
}  // namespace psmks
