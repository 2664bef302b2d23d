/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/core/align.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <future>
#include <limits>

namespace psmks
{
namespace
{
using Ranges = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const BeamGrid kGrid = BeamGrid::centered(degToRad(270), 541);
const Pose2 kMotion{0.30, 0.10, degToRad(7)};

/** An L-shaped room, seen from r and from c, 0.3 m further:
 *
 *     (-2,3)-----------(3,3)
 *        |               |
 *        |   r> c>       |      r at the origin, looking to the right
 *        |          (1,-1)--(3,-1)
 *        |            |
 *     (-2,-3)-----(1,-3)                                                                 */
Ranges lShapedRoomFrom(const Pose2& T_world_sensor)
{
  const auto walls = outline({{-2, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 3}, {-2, 3}});
  return castScan(walls, T_world_sensor, kGrid).range_m;
}

Scan scanOf(const Ranges& range_m)
{
  Scan scan;
  scan.grid = kGrid;
  scan.range_m = range_m;
  return scan;
}

std::vector<float> inSinglePrecision(const Ranges& range_m)
{
  return std::vector<float>(range_m.begin(), range_m.end());
}

/** What a failure gives: the guess, and a covariance that is large. */
void expectInvalidInput(const MatchResult& match, const Guess& guess)
{
  EXPECT_EQ(match.status, MatchStatus::InvalidInput) << match.report();
  EXPECT_FALSE(match.usable());
  EXPECT_TRUE(isNearly(match.T_ref_cur, guess.T_ref_cur, 0, 0));
  EXPECT_EQ(match.covariance, MatchResult::unknownCovariance());
}
}  // namespace

TEST(Align, FindsTheMotionBetweenPlainRanges)
{
  const Ranges reference_m = lShapedRoomFrom({}), current_m = lShapedRoomFrom(kMotion);
  const MatchResult match = align(reference_m, current_m, kGrid);
  EXPECT_EQ(match.status, MatchStatus::Converged);
  EXPECT_TRUE(isNearly(match.T_ref_cur, kMotion, 1e-3, degToRad(0.02))) << match.report();
}

TEST(Align, TakesRangesInSinglePrecision)
{
  const MatchResult match = align(inSinglePrecision(lShapedRoomFrom({})),
                                  inSinglePrecision(lShapedRoomFrom(kMotion)), kGrid);
  EXPECT_TRUE(isNearly(match.T_ref_cur, kMotion, 1e-3, degToRad(0.02))) << match.report();
}

TEST(Align, GivesWhatAMatcherThatIsKeptGives)
{
  const Scan reference = scanOf(lShapedRoomFrom({})), current = scanOf(lShapedRoomFrom(kMotion));
  const Matcher matcher;
  MatcherWorkspace workspace;
  const MatchResult kept = matcher.match(reference, current, {}, workspace);
  for (const MatchResult& match :
       {align(reference, current), align(reference.range_m, current.range_m, kGrid)})
  {
    EXPECT_TRUE(isNearly(match.T_ref_cur, kept.T_ref_cur, 0, 0));
    EXPECT_EQ(match.covariance, kept.covariance);
    EXPECT_EQ(match.score, kept.score);
  }
}

TEST(Align, MatchesScansOfTwoScanners)
{
  Scan current;
  current.grid = BeamGrid(degToRad(-100), degToRad(0.4), 501);
  const auto walls = outline({{-2, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 3}, {-2, 3}});
  current.range_m = castScan(walls, kMotion, current.grid).range_m;
  const MatchResult match = align(scanOf(lShapedRoomFrom({})), current);
  EXPECT_TRUE(isNearly(match.T_ref_cur, kMotion, 1e-3, degToRad(0.02))) << match.report();
}

// Without a guess at most 120 degrees are searched, to either side.
TEST(Align, StartsAtTheGuess)
{
  const Pose2 turned{0.2, 0.1, degToRad(170)};
  const Ranges reference_m = lShapedRoomFrom({}), current_m = lShapedRoomFrom(turned);
  Guess guess;
  guess.T_ref_cur = {0, 0, degToRad(160)};
  const MatchResult match = align(reference_m, current_m, kGrid, guess);
  EXPECT_TRUE(isNearly(match.T_ref_cur, turned, 1e-3, degToRad(0.02))) << match.report();
  EXPECT_FALSE(isNearly(align(reference_m, current_m, kGrid).T_ref_cur, turned, 0.1, degToRad(5)));
}

TEST(Align, ObeysItsOptions)
{
  MatcherOptions options;
  options.preprocessing.maxRange_m = 0.5;  // nothing in the room is as near
  const Ranges range_m = lShapedRoomFrom({});
  expectInvalidInput(align(range_m, range_m, kGrid, {}, options), {});
}

TEST(Align, LeavesOutRaysWithoutAReturn)
{
  Ranges reference_m = lShapedRoomFrom({}), current_m = lShapedRoomFrom(kMotion);
  const double noReturns[] = {kNan, kInfinity, -kInfinity, 0, -1};
  for (std::size_t i = 0; i < reference_m.size(); i += 7)
  {
    reference_m[i] = noReturns[i % 5];
    current_m[i] = noReturns[(i + 2) % 5];
  }
  const MatchResult match = align(reference_m, current_m, kGrid);
  EXPECT_TRUE(isNearly(match.T_ref_cur, kMotion, 1e-3, degToRad(0.02))) << match.report();
}

TEST(Align, KeepsTheGuessWhereAScanHasNoReturn)
{
  const Ranges room_m = lShapedRoomFrom({});
  Guess guess;
  guess.T_ref_cur = {0.1, 0.2, 0.3};
  for (const double noReturn : {kNan, kInfinity, 0.0})
  {
    const Ranges nothing_m(room_m.size(), noReturn);
    expectInvalidInput(align(room_m, nothing_m, kGrid, guess), guess);
    expectInvalidInput(align(nothing_m, room_m, kGrid, guess), guess);
  }
}

TEST(Align, KeepsTheGuessWhereRangesDoNotFitTheGrid)
{
  const Ranges fits_m = lShapedRoomFrom({});
  Ranges oneFewer_m = fits_m, oneMore_m = fits_m;
  oneFewer_m.pop_back();
  oneMore_m.push_back(1);
  for (const Ranges& misfit_m : {Ranges(), oneFewer_m, oneMore_m})
  {
    expectInvalidInput(align(fits_m, misfit_m, kGrid), {});
    expectInvalidInput(align(misfit_m, fits_m, kGrid), {});
    expectInvalidInput(align(misfit_m, misfit_m, kGrid), {});
  }
}

TEST(Align, KeepsTheGuessWhereThereIsNothingAtAll)
{
  expectInvalidInput(align(Scan(), Scan()), {});
  expectInvalidInput(align(Ranges(), Ranges(), BeamGrid()), {});
}

TEST(Align, AGuessBeyondSinglePrecisionIsInvalidInput)
{
  const Ranges room_m = lShapedRoomFrom({});
  for (const double far_m : {1e16, -1e30, 1e300})
    expectInvalidInput(align(room_m, room_m, kGrid, {{far_m, 0, 0}, {}}), {{far_m, 0, 0}, {}});
}

TEST(Align, RefusesOptionsThatItCannotServe)
{
  MatcherOptions options;
  options.joint.solver = JointSolver::Ceres;
  const Ranges range_m = lShapedRoomFrom({});
  EXPECT_THROW(align(range_m, range_m, kGrid, {}, options), OptionError);
}

TEST(Align, GivesTheSameInSeveralThreadsAtOnce)
{
  const Ranges reference_m = lShapedRoomFrom({}), current_m = lShapedRoomFrom(kMotion);
  const auto match = [&] { return align(reference_m, current_m, kGrid); };
  const MatchResult alone = match();
  std::vector<std::future<MatchResult>> together;
  for (int i = 0; i < 4; ++i) together.push_back(std::async(std::launch::async, match));
  for (auto& result : together) EXPECT_EQ(result.get().covariance, alone.covariance);
}
}  // namespace psmks
