/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/joint/CorrelativeSearch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>

namespace psmks
{
namespace
{
// The room of officeRoom(): the scanner has gone 2.2 m and turned by 75 degrees.
const Pose2 kFar{1.4, 1.7, degToRad(75)};
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 360);

/** The last steps are of 12 cm and 1.5 degrees: beside the best of them the truth may lie one step
 * farther in x and in y, 17 cm away. Headings whose rays stay within the tolerance of 15 cm score
 * alike: 3 degrees move a wall 3 m away by so much. From there the refinement, with gates of 20 cm,
 * finds the truth. */
const double kNear_m = 0.12 * std::sqrt(2), kNear_rad = degToRad(3);

class CorrelativeSearchTest : public testing::Test
{
 protected:
  std::vector<Hypothesis> startsAbout(const Pose2& guess, const CorrelativeLimits& limits)
  {
    std::vector<Hypothesis> starts{{{99, 99, 99}, 1, 1}};  // of an earlier search
    search_.propose(scene_.scores(), guess, limits, starts);
    return starts;
  }

  JointScene scene_{officeRoom(), kFar, kAround};
  CorrelativeSearch search_;
  static constexpr CorrelativeLimits kWide{3, degToRad(120), 80};
};
}  // namespace

TEST_F(CorrelativeSearchTest, TheStartThatExplainsMostIsTheTruth)
{
  for (const Pose2& guess : {Pose2{}, Pose2{0.27, 0.38, degToRad(-20)}, Pose2{-0.6, 0.9, 2}})
  {
    const std::vector<Hypothesis> starts = startsAbout(guess, kWide);
    ASSERT_FALSE(starts.empty());
    EXPECT_TRUE(isNearly(starts[0].T_ref_cur, kFar, kNear_m, kNear_rad));
  }
}

TEST_F(CorrelativeSearchTest, StartsComeInTheOrderOfTheirScores)
{
  const std::vector<Hypothesis> starts = startsAbout({}, kWide);
  ASSERT_GT(starts.size(), 1U);
  EXPECT_TRUE(std::is_sorted(starts.begin(), starts.end(),
                             [](const Hypothesis& a, const Hypothesis& b)
                             { return a.score > b.score; }));
}

// Two starts within the gates of the refinement would lead to one pose.
TEST_F(CorrelativeSearchTest, NoTwoStartsLeadToOnePlace)
{
  const std::vector<Hypothesis> starts = startsAbout({}, kWide);
  for (const Hypothesis& a : starts)
    for (const Hypothesis& b : starts)
      EXPECT_TRUE(&a == &b || !isNearly(a.T_ref_cur, b.T_ref_cur, 0.2, degToRad(4)));
}

// From the grid a start moves on to where it scores best, by at most one spacing of 0.5 m and 6
// degrees.
TEST_F(CorrelativeSearchTest, StartsAreWithinTheLimitsAboutTheGuess)
{
  const Pose2 guess{0.2, -0.3, degToRad(175)};
  const CorrelativeLimits narrow{1, degToRad(30), 80};
  for (const Hypothesis& start : startsAbout(guess, narrow))
  {
    const Pose2& T = start.T_ref_cur;
    EXPECT_LE((T.translation() - guess.translation()).norm(), narrow.radius_m + 0.5 * std::sqrt(2));
    EXPECT_LE(std::abs(wrapAngle(T.phi_rad - guess.phi_rad)), narrow.angle_rad + degToRad(6));
  }
}

TEST_F(CorrelativeSearchTest, ARadiusOfZeroTriesHeadingsAlone)
{
  for (const Hypothesis& start : startsAbout({}, {0, degToRad(120), 80}))
    EXPECT_LE(start.T_ref_cur.translation().norm(), 0.5 * std::sqrt(2));
}

TEST_F(CorrelativeSearchTest, NoMoreStartsComeThanPlacesAreFollowed)
{
  EXPECT_LE(startsAbout({}, {3, degToRad(120), 2}).size(), 2U);
  EXPECT_TRUE(startsAbout({}, {3, degToRad(120), 0}).empty());
}

// One match through all steps, which the parts alone do not hold: the wide search is made where
// nothing near the guess is found, and leads to the pose.
TEST(CorrelativeSearch, FindsWhatIsFartherThanTheSearchAboutTheGuess)
{
  MatcherWorkspace workspace;
  const MatchResult result =
      Matcher().match(castScan(officeRoom(), {}, kAround), castScan(officeRoom(), kFar, kAround),
                      Guess{}, workspace);
  ASSERT_TRUE(result.usable()) << result.report();
  // The scans are exact: what is left is the rounding of the search's steps.
  EXPECT_TRUE(isNearly(result.T_ref_cur, kFar, 0.01, degToRad(0.2))) << result.report();
}
}  // namespace psmks
