/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/ReferencePolicy.h>

namespace psmks
{
namespace
{
MatchResult matchOf(MatchStatus status, double score = 1, int associations = 100)
{
  MatchResult result;
  result.status = status;
  result.score = score;
  result.associations = associations;
  return result;
}

const MatchResult kGood = matchOf(MatchStatus::Converged);
const MatchResult kFailed = matchOf(MatchStatus::NoImprovement);
const Pose2 kNear{0.1, 0, 0}, kFar{0.9, 0, 0}, kTurned{0, 0, degToRad(-25)};

TEST(ReferencePolicy, sequentialReplacesTheReferenceOnceMovedOrTurnedFarEnough)
{
  const ReferencePolicy policy{ReferenceOptions()};
  EXPECT_FALSE(policy.isReplaced(kGood, kNear, 0));
  EXPECT_TRUE(policy.isReplaced(kGood, kFar, 0));
  EXPECT_TRUE(policy.isReplaced(kGood, kTurned, 0));
}

TEST(ReferencePolicy, onlyThePaperLeavesScansNearTheReferenceUnmatched)
{
  ReferenceOptions options;
  EXPECT_TRUE(ReferencePolicy(options).isMatched(kNear));
  options.matchEveryScan = false;
  EXPECT_FALSE(ReferencePolicy(options).isMatched(kNear));
  EXPECT_TRUE(ReferencePolicy(options).isMatched(kFar));
}

TEST(ReferencePolicy, aKeyframeStaysUntilTooLittleOfItIsSeen)
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Keyframe;
  const ReferencePolicy policy(options);
  EXPECT_FALSE(policy.isReplaced(kGood, kFar, 0));
  EXPECT_TRUE(policy.isReplaced(kGood, {2.1, 0, 0}, 0));
  EXPECT_TRUE(policy.isReplaced(kGood, {0, 0, degToRad(41)}, 0));
  EXPECT_TRUE(policy.isReplaced(matchOf(MatchStatus::Converged, 0.4), kNear, 0));
  EXPECT_TRUE(policy.isReplaced(matchOf(MatchStatus::Converged, 1, 29), kNear, 0));
}

TEST(ReferencePolicy, afterAFailureTheReferenceWaitsUntilItIsGivenUp)
{
  ReferenceOptions options;
  options.maxFailures = 3;
  const ReferencePolicy policy(options);
  EXPECT_FALSE(policy.isReplaced(kFailed, kFar, 1));
  EXPECT_FALSE(policy.isReplaced(kFailed, kFar, 2));
  EXPECT_TRUE(policy.isReplaced(kFailed, kFar, 3));
}
}  // namespace
}  // namespace psmks
