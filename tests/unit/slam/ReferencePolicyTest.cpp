/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/PoseGraph.h>
#include <psmks/slam/ReferencePolicy.h>

#include <Eigen/LU>

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

TEST(ReferencePolicy, SequentialReplacesTheReferenceOnceMovedOrTurnedFarEnough)
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Sequential;
  const ReferencePolicy policy(options);
  EXPECT_FALSE(policy.replacesReference(kGood, kNear, 0));
  EXPECT_TRUE(policy.replacesReference(kGood, kFar, 0));
  EXPECT_TRUE(policy.replacesReference(kGood, kTurned, 0));
}

TEST(ReferencePolicy, OnlyThePaperLeavesScansNearTheReferenceUnmatched)
{
  ReferenceOptions options;
  EXPECT_TRUE(ReferencePolicy(options).needsMatch(kNear));
  options.matchEveryScan = false;
  EXPECT_FALSE(ReferencePolicy(options).needsMatch(kNear));
  EXPECT_TRUE(ReferencePolicy(options).needsMatch(kFar));
}

TEST(ReferencePolicy, AKeyframeStaysUntilTooLittleOfItIsSeen)
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Keyframe;
  const ReferencePolicy policy(options);
  EXPECT_FALSE(policy.replacesReference(kGood, kFar, 0));
  EXPECT_TRUE(policy.replacesReference(kGood, {2.1, 0, 0}, 0));
  EXPECT_TRUE(policy.replacesReference(kGood, {0, 0, degToRad(41)}, 0));
  EXPECT_TRUE(policy.replacesReference(matchOf(MatchStatus::Converged, 0.29), kFar, 0));
  EXPECT_FALSE(policy.replacesReference(matchOf(MatchStatus::Converged, 0.31), kFar, 0));
  EXPECT_TRUE(policy.replacesReference(matchOf(MatchStatus::Converged, 1, 29), kFar, 0));
  EXPECT_FALSE(policy.replacesReference(matchOf(MatchStatus::Converged, 0.29, 29), kNear, 0));
}

TEST(ReferencePolicy, WhatAPathMayLeaveOpenHoldsAllThatIsKnown)
{
  const ReferencePolicy policy{ReferenceOptions()};
  const auto with = [](double sigma_m, double sigma_rad)
  {
    return Eigen::Matrix3d(
        Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal());
  };
  const Eigen::Matrix3d worstKnown = with(0.0999, degToRad(1.499));
  EXPECT_TRUE(policy.isKnown(worstKnown));
  EXPECT_LT(leftOpen_m(worstKnown), policy.mostOpen_m());
  EXPECT_FALSE(policy.isKnown(with(0.1001, 0)));
  EXPECT_FALSE(policy.isKnown(with(0, degToRad(1.501))));
  EXPECT_GT(leftOpen_m(with(0.5, 0)), policy.mostOpen_m());
}

TEST(ReferencePolicy, AfterAFailureTheReferenceWaitsUntilItIsGivenUp)
{
  ReferenceOptions options;
  options.maxFailures = 3;
  const ReferencePolicy policy(options);
  EXPECT_FALSE(policy.replacesReference(kFailed, kFar, 1));
  EXPECT_FALSE(policy.replacesReference(kFailed, kFar, 2));
  EXPECT_TRUE(policy.replacesReference(kFailed, kFar, 3));
}

// ---- map: a keyframe every metre or 30 degrees, of use within 4 m and 60 degrees ---------------

ReferencePolicy mapPolicy()
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Map;
  return ReferencePolicy(options);
}

TEST(ReferencePolicy, OnlyOneOfTheChoicesIsAMap)
{
  EXPECT_TRUE(mapPolicy().usesMap());
  for (const auto choice : {ReferenceChoice::Sequential, ReferenceChoice::Keyframe})
  {
    ReferenceOptions options;
    options.choice = choice;
    EXPECT_FALSE(ReferencePolicy(options).usesMap());
  }
}

TEST(ReferencePolicy, AKeyframeIsWithinReachInPlaceAndHeading)
{
  EXPECT_TRUE(mapPolicy().isWithinReach({2.7, -2.7, degToRad(-59)}));  // 3.8 m away
  EXPECT_FALSE(mapPolicy().isWithinReach({2.9, -2.9, 0}));
  EXPECT_FALSE(mapPolicy().isWithinReach({0, 0, degToRad(-61)}));
}

TEST(ReferencePolicy, AKeyframeCoversWhatIsNearInPlaceAndHeading)
{
  EXPECT_TRUE(mapPolicy().isCovered({0.6, -0.6, degToRad(29)}));
  EXPECT_FALSE(mapPolicy().isCovered({0.8, -0.8, 0}));
  EXPECT_FALSE(mapPolicy().isCovered({0, 0, degToRad(31)}));
}

TEST(ReferencePolicy, TheNormalizedDistanceAddsPlaceAndHeading)
{
  EXPECT_EQ(mapPolicy().normalizedDistance({}), 0);
  EXPECT_NEAR(mapPolicy().normalizedDistance({0, -4, 0}), 1, 1e-12);
  EXPECT_NEAR(mapPolicy().normalizedDistance({0, 0, degToRad(-60)}), 1, 1e-12);
  EXPECT_NEAR(mapPolicy().normalizedDistance({2.4, 3.2, degToRad(60)}), 2, 1e-12);
}

TEST(ReferencePolicy, AKeyframeThatSawHalfOfAScanSawEnough)
{
  EXPECT_TRUE(mapPolicy().overlapsEnough(0.5));
  EXPECT_FALSE(mapPolicy().overlapsEnough(0.49));
}

TEST(ReferencePolicy, AUsableMatchThatExplainsMostRaysLinksKeyframes)
{
  for (const MatchStatus status :
       {MatchStatus::Converged, MatchStatus::MaxIterations, MatchStatus::Degenerate})
  {
    EXPECT_TRUE(mapPolicy().isLink(matchOf(status, 0.6)));
    EXPECT_FALSE(mapPolicy().isLink(matchOf(status, 0.59)));
  }
  EXPECT_FALSE(mapPolicy().isLink(matchOf(MatchStatus::NoImprovement)));
}

TEST(ReferencePolicy, AMatchThatExplainsLittleIsRetried)
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Sequential;
  options.retryScore = 0.9;
  options.mapRetryScore = 0.7;
  const ReferencePolicy sequential(options);
  EXPECT_TRUE(sequential.needsRetry(matchOf(MatchStatus::Converged, 0.89)));
  EXPECT_FALSE(sequential.needsRetry(matchOf(MatchStatus::Converged, 0.9)));
  EXPECT_TRUE(sequential.needsRetry(matchOf(MatchStatus::NoImprovement, 0.95)));
  options.choice = ReferenceChoice::Map;
  EXPECT_FALSE(ReferencePolicy(options).needsRetry(matchOf(MatchStatus::Converged, 0.7)));
  EXPECT_TRUE(ReferencePolicy(options).needsRetry(matchOf(MatchStatus::Converged, 0.69)));
  options.retryLastScan = false;
  EXPECT_FALSE(ReferencePolicy(options).needsRetry(matchOf(MatchStatus::NoImprovement, 0)));
}

TEST(ReferencePolicy, ARetryHasToBeClearlyBetter)
{
  const MatchResult weak = matchOf(MatchStatus::Converged, 0.8);
  EXPECT_TRUE(mapPolicy().isBetter(matchOf(MatchStatus::Converged, 0.9), weak));
  EXPECT_FALSE(mapPolicy().isBetter(matchOf(MatchStatus::Converged, 0.82), weak));
  EXPECT_FALSE(mapPolicy().isBetter(matchOf(MatchStatus::Degenerate, 0.9), weak));
}

TEST(ReferencePolicy, KeyframesAreLinkedToTheLastFewAndThoseOfAMapToAny)
{
  ReferenceOptions options;
  options.keyframeWindow = 20;
  options.choice = ReferenceChoice::Keyframe;
  EXPECT_EQ(ReferencePolicy(options).firstLinkable(15), 0U);
  EXPECT_EQ(ReferencePolicy(options).firstLinkable(50), 30U);
  EXPECT_TRUE(ReferencePolicy(options).linksReferences());
  EXPECT_EQ(mapPolicy().firstLinkable(50), 0U);
  options.choice = ReferenceChoice::Sequential;
  EXPECT_FALSE(ReferencePolicy(options).linksReferences());
}

Eigen::Matrix3d covarianceOf(double sigmaX_m, double sigmaY_m, double sigma_deg)
{
  return Eigen::Vector3d(sigmaX_m, sigmaY_m, degToRad(sigma_deg)).cwiseAbs2().asDiagonal();
}

TEST(ReferencePolicy, APoseIsKnownToADecimetreAndADegreeAndAHalf)
{
  EXPECT_TRUE(mapPolicy().isKnown(covarianceOf(0.09, 0.09, 1.4)));
  EXPECT_FALSE(mapPolicy().isKnown(covarianceOf(0.01, 0.11, 0)));
  EXPECT_FALSE(mapPolicy().isKnown(covarianceOf(0.01, 0.01, 1.6)));
}

TEST(ReferencePolicy, APlaceIsSearchedWithinThreeStandardDeviations)
{
  ReferenceOptions options;
  options.mapDistance_m = 4;
  EXPECT_NEAR(ReferencePolicy(options).loopReach_m(covarianceOf(0.5, 2, 1)), 4 + 3 * 2, 1e-9);
}

TEST(ReferencePolicy, ALinkIsLessCertainThanItsMatchByWhatTheOptionsSay)
{
  Eigen::Matrix3d match;
  match << 4e-6, 1e-6, 2e-7, 1e-6, 9e-6, 0, 2e-7, 0, 1e-6;
  const Eigen::Matrix3d information = match.inverse();
  ReferenceOptions options;
  options.linkSigma_m = 0;
  options.linkSigma_rad = 0;
  EXPECT_TRUE(ReferencePolicy(options).linkInformation(information).isApprox(information, 1e-9));
  options.linkSigma_m = 0.01;
  options.linkSigma_rad = 0.002;
  const Eigen::Matrix3d added =
      ReferencePolicy(options).linkInformation(information).inverse() - match;
  EXPECT_TRUE(added.isApprox(Eigen::Vector3d(1e-4, 1e-4, 4e-6).asDiagonal().toDenseMatrix(), 1e-9));
}

TEST(ReferencePolicy, ADirectionThatAMatchLeavesOpenIsLeftOpenByItsLink)
{
  const Eigen::Matrix3d information = Eigen::Vector3d(0, 1e6, 1e6).asDiagonal();
  const Eigen::Matrix3d ofLink = mapPolicy().linkInformation(information);
  EXPECT_EQ(ofLink(0, 0), 0);
  EXPECT_NEAR(ofLink(1, 1), 1 / (1e-6 + 0.005 * 0.005), 1);
}

TEST(ReferencePolicy, EveryOptionStandsInTheTable)
{
  ReferenceOptions options;
  OptionTable table;
  listFields(table, options);
  table.set("reference", "link_sigma_m", "0.02");
  table.set("reference", "link_sigma_deg", "0.5");
  EXPECT_EQ(options.linkSigma_m, 0.02);
  EXPECT_DOUBLE_EQ(options.linkSigma_rad, degToRad(0.5));
  EXPECT_EQ(table.fields().size(), 23U);
}

TEST(ReferencePolicy, TheNumberOfLinksIsAnOption)
{
  ReferenceOptions options;
  options.mapLinks = 3;
  EXPECT_EQ(ReferencePolicy(options).maxLinks(), 3U);
}
}  // namespace
}  // namespace psmks
