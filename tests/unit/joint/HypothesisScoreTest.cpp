/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/HypothesisScore.h>
#include <tests/unit/joint/JointScene.h>

namespace psmks
{
namespace
{
//  +-------+
//  |   o   |   a scanner in the middle of a square room: at four headings it sees the same
//  +-------+
class HypothesisScoreInASquare : public testing::Test
{
 protected:
  double scoreOf(double heading_deg, const Pose2& guess) const
  {
    return HypothesisScore(scores_, guess, scene_.options).of({0, 0, degToRad(heading_deg)});
  }

  JointScene scene_{squareRoom(), {}, BeamGrid::centered(2 * kPi, 360)};
  ScanScores scores_ = scene_.scores();
};
}  // namespace

TEST_F(HypothesisScoreInASquare, AtTheGuessItIsTheRoughScore)
{
  ASSERT_EQ(scores_.roughScore({}), 1);
  EXPECT_EQ(scoreOf(0, {}), 1);
  EXPECT_EQ(HypothesisScore(scores_, {0.5, 0, 0}, scene_.options).of({0.5, 0, 0}),
            scores_.roughScore({0.5, 0, 0}));
}

TEST_F(HypothesisScoreInASquare, OfHeadingsThatLookAlikeTheNearerToTheGuessIsPreferred)
{
  ASSERT_EQ(scores_.roughScore({0, 0, kPi / 2}), 1) << "all four look alike";
  const Pose2 guess{0, 0, degToRad(70)};
  EXPECT_GT(scoreOf(90, guess), scoreOf(0, guess));     // 20 degrees away, 70
  EXPECT_GT(scoreOf(0, guess), scoreOf(180, guess));    // 110
  EXPECT_GT(scoreOf(180, guess), scoreOf(-90, guess));  // 160
}

TEST_F(HypothesisScoreInASquare, TurningLeftAndRightAreEqual)
{
  EXPECT_NEAR(scoreOf(90, {}), scoreOf(-90, {}), 1e-12);
  EXPECT_NEAR(scoreOf(180, {0, 0, degToRad(170)}), scoreOf(180, {0, 0, degToRad(-170)}), 1e-12);
}

// -----------------  bare walls, 60 m long: places along them look alike
//     o     x
// -----------------
TEST(HypothesisScoreInACorridor, OfPlacesThatLookAlikeTheNearerToTheGuessIsPreferred)
{
  JointScene scene(corridor(), {}, BeamGrid::centered(2 * kPi, 360), 8);
  const ScanScores scores = scene.scores();
  const HypothesisScore score(scores, {1, 0, 0}, scene.options);
  ASSERT_EQ(scores.roughScore({0.4, 0, 0}), scores.roughScore({2, 0, 0}));
  EXPECT_GT(score.of({0.4, 0, 0}), score.of({2, 0, 0}));  // 0.6 m from the guess, 1 m
  EXPECT_GT(score.of({1.3, 0, 0}), score.of({0.4, 0, 0}));
}

// The preference must not hide the truth, which explains the scans better: from the far end of the
// search a wrong start at the guess may not win.
TEST(HypothesisScoreInAnOffice, AtTheLimitsOfTheSearchTheTruthBeatsAWrongGuess)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  for (const double turned_deg : {-60.0, 0.0, 60.0})
    for (const double side : {-1.0, 1.0})
    {
      const Pose2 truth{0, 1.2 * side, degToRad(turned_deg)};
      JointScene scene(officeRoom(), truth, grid);
      const ScanScores scores = scene.scores();
      const HypothesisScore score(scores, {}, scene.options);
      EXPECT_GT(score.of(truth), score.of({})) << turned_deg << " deg, " << truth.y_m << " m";
    }
}
}  // namespace psmks
