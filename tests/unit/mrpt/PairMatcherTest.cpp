/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/PairMatcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>
#include <tests/support/ThrownText.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
const Pose2 T_ref_cur{0.15, -0.1, degToRad(4)};
const Pose2 kGuess{0.12, -0.08, degToRad(3)};

Scan roomScan(const Pose2& pose)
{
  return castScan(officeRoom(), pose, BeamGrid::centered(degToRad(270), 541));
}

TEST(PairMatcher, everyMatcherOfTheRegistryFindsASmallMotionInARoom)
{
  for (const auto& name : pairMatcherNames())
  {
    if (name == "guess") continue;
    const auto matcher = makePairMatcher(name);
    EXPECT_EQ(matcher->name(), name);
    const MatchResult result = matcher->match(roomScan({}), roomScan(T_ref_cur), {kGuess, {}});
    EXPECT_TRUE(result.usable()) << name;
    EXPECT_TRUE(isNearly(result.T_ref_cur, T_ref_cur, 0.02, degToRad(0.5))) << name;
    EXPECT_GT(result.covariance.determinant(), 0) << name;
  }
}

TEST(PairMatcher, aReferenceThatWasSetIsMatchedAsOneThatIsGiven)
{
  for (const auto& name : pairMatcherNames())
  {
    const auto matcher = makePairMatcher(name);
    const Scan reference = roomScan({}), current = roomScan(T_ref_cur);
    const MatchResult direct = matcher->match(reference, current, {kGuess, {}});
    matcher->setReference(reference);
    const MatchResult kept = matcher->matchToReference(current, {kGuess, {}});
    EXPECT_TRUE(isNearly(kept.T_ref_cur, direct.T_ref_cur, 1e-12, 1e-12)) << name;
    EXPECT_EQ(kept.status, direct.status) << name;
  }
}

TEST(PairMatcher, scansWithoutReturnsAreAFailureThatKeepsTheGuess)
{
  for (const auto& name : pairMatcherNames())
  {
    if (name == "guess") continue;
    const MatchResult result = makePairMatcher(name)->match(Scan(), roomScan({}), {kGuess, {}});
    EXPECT_EQ(result.status, MatchStatus::InvalidInput) << name;
    EXPECT_TRUE(isNearly(result.T_ref_cur, kGuess, 0, 0)) << name;
    EXPECT_GT(result.covariance.determinant(), 0) << name;
  }
}

TEST(PairMatcher, anUnknownNameIsRefusedWithTheKnownOnes)
{
  const std::string text = test::thrownText<OptionError>([] { makePairMatcher("csm"); });
  EXPECT_NE(text.find("'csm'"), std::string::npos);
  EXPECT_NE(text.find("icp-classic"), std::string::npos);
}
}  // namespace
}  // namespace psmks
