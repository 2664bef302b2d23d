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

TEST(WideSearch, FindsWhatIsFartherThanTheSearchAboutTheGuess)
{
  const MatchResult result = matchFar({});
  ASSERT_TRUE(result.usable()) << result.report();
  EXPECT_LT((result.T_ref_cur.translation() - kFar.translation()).norm(), 0.01);
  EXPECT_LT(std::abs(wrapAngle(result.T_ref_cur.phi_rad - kFar.phi_rad)), degToRad(0.2));
}

TEST(WideSearch, IsSwitchedOffByARadiusOfZero)
{
  MatcherOptions options;
  options.joint.wideRadius_m = 0;
  const MatchResult result = matchFar(options);
  EXPECT_TRUE(!result.usable() ||
              (result.T_ref_cur.translation() - kFar.translation()).norm() > 0.5)
      << result.report();
}
}  // namespace psmks
