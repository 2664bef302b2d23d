/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>
#include <tests/support/ThrownText.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

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

TEST(PairMatcher, EveryMatcherOfTheRegistryFindsASmallMotionInARoom)
{
  for (const auto& name : pairMatcherNames())
  {
    if (name == "guess") continue;
    const auto matcher = makePairMatcher(name);
    EXPECT_EQ(matcher->name(), name);
    const MatchResult result = matcher->match(roomScan({}), roomScan(T_ref_cur), {kGuess, {}});
    EXPECT_TRUE(result.usable()) << name;
    EXPECT_TRUE(isNearly(result.T_ref_cur, T_ref_cur, 0.02, degToRad(0.7))) << name;
    EXPECT_GT(result.covariance.determinant(), 0) << name;
  }
}

/** How far a matcher ends from the true position in the room, on average over steps to all sides,
 * the guess being that the robot stood still. */
double meanError_m(const std::string& name)
{
  constexpr int kSteps = 8;
  const auto matcher = makePairMatcher(name);
  double sum_m = 0;
  for (int step = 0; step < kSteps; ++step)
  {
    const double direction_rad = 2 * kPi * step / kSteps;
    const Pose2 truth{0.2 * std::cos(direction_rad), 0.2 * std::sin(direction_rad), degToRad(5)};
    const Pose2 found = matcher->match(roomScan({}), roomScan(truth), {}).T_ref_cur;
    sum_m += (found.translation() - truth.translation()).norm();
  }
  return sum_m / kSteps;
}

TEST(PairMatcher, WhatIsTunedForAccuracyIsMoreAccurateThanTheDefault)
{
  EXPECT_LT(meanError_m("icp-classic-tuned"), meanError_m("icp-classic"));
  EXPECT_LT(meanError_m("icp-lm-tuned"), meanError_m("icp-lm"));
}

TEST(PairMatcher, AReferenceThatWasSetIsMatchedAsOneThatIsGiven)
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

TEST(PairMatcher, ScansWithoutReturnsAreAFailureThatKeepsTheGuess)
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

TEST(PairMatcher, AnUnknownNameIsRefusedWithTheKnownOnes)
{
  const std::string text = test::thrownText<OptionError>([] { makePairMatcher("csm"); });
  EXPECT_NE(text.find("'csm'"), std::string::npos);
  EXPECT_NE(text.find("icp-classic"), std::string::npos);
}

bool isKnown(const std::string& name)
{
  const auto names = pairMatcherNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

PairMatcherEntry guessNamed(const std::string& name)
{
  return {name, "made up", PairMatcherFamily::Guess, 1,
          [](const std::string&, const MatcherOptions&) { return makePairMatcher("guess"); }};
}

TEST(PairMatcherRegistration, NamesAreUniqueAndDescribedInOneLine)
{
  std::set<std::string> names;
  for (const auto& entry : pairMatcherEntries())
  {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.description.empty()) << entry.name;
    EXPECT_EQ(entry.description.find('\n'), std::string::npos) << entry.name;
  }
}

TEST(PairMatcherRegistration, OursAreListedFirstAndTheGuessLast)
{
  const auto names = pairMatcherNames();
  EXPECT_EQ(names.front(), "psmks");
  EXPECT_EQ(names.back(), "guess");
}

TEST(PairMatcherRegistration, MakesAMatcherKnownForAsLongAsItLives)
{
  {
    const PairMatcherRegistration registration(guessNamed("passing"));
    EXPECT_TRUE(isKnown("passing"));
    EXPECT_EQ(pairMatcherNames().back(), "passing") << "the place in the family counts";
    EXPECT_EQ(makePairMatcher("passing")->name(), "guess");
  }
  EXPECT_FALSE(isKnown("passing"));
  EXPECT_THROW(makePairMatcher("passing"), OptionError);
}

TEST(PairMatcherRegistration, RefusesANameThatIsTaken)
{
  EXPECT_THROW(PairMatcherRegistration{guessNamed("psmks")}, std::logic_error);
  EXPECT_TRUE(isKnown("psmks")) << "the one that has the name keeps it";
}
}  // namespace
}  // namespace psmks
