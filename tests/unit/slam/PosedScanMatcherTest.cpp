/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/PosedScanMatcher.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
/** What a matcher was asked, and what it answers. */
struct Dialogue
{
  int prepared = 0;
  Guess guess;
  SearchScope scope = SearchScope::Full;
  MatchResult answer;
};

class ScriptedMatcher : public PairMatcher
{
 public:
  explicit ScriptedMatcher(Dialogue& dialogue) : dialogue_(dialogue) {}

  std::string name() const override { return "scripted"; }
  MatchResult match(const Scan&, const Scan&, const Guess&) override { return dialogue_.answer; }
  std::unique_ptr<PreparedScan> prepare(const Scan& scan, const ScannerNoise& scanner) override
  {
    ++dialogue_.prepared;
    return PairMatcher::prepare(scan, scanner);
  }
  MatchResult matchPrepared(const PreparedScan&, const PreparedScan&, const Guess& guess,
                            SearchScope scope) override
  {
    dialogue_.guess = guess;
    dialogue_.scope = scope;
    return dialogue_.answer;
  }

 private:
  Dialogue& dialogue_;
};

//      robot --0.5 m--> sensor        The first scanner sits ahead of its robot, the second one
//                                     looks to the left of its robot.
class PosedScanMatcherTest : public testing::Test
{
 protected:
  PosedScanMatcherTest() : scans_(2)
  {
    scans_[0].T_robot_sensor = {0.5, 0, 0};
    scans_[1].T_robot_sensor = {0, 0, degToRad(90)};
  }

  Dialogue dialogue_;
  std::vector<PosedScan> scans_;
  PosedScanMatcher matcher_{std::make_unique<ScriptedMatcher>(dialogue_)};
  const Eigen::Matrix3d covariance_ = Eigen::Vector3d(0.01, 0.02, 0.001).asDiagonal();
};
}  // namespace

TEST_F(PosedScanMatcherTest, TheGuessOfTheRobotsReachesTheMatcherAsThatOfTheSensors)
{
  matcher_.match(scans_, 0, 1, {{1, 0.2, 0}, covariance_}, SearchScope::NearGuess);
  EXPECT_TRUE(isNearly(dialogue_.guess.T_ref_cur, {0.5, 0.2, degToRad(90)}, 1e-12, 1e-12));
  ASSERT_TRUE(dialogue_.guess.covariance);
  EXPECT_NEAR((*dialogue_.guess.covariance)(2, 2), 0.001, 1e-12);
  EXPECT_EQ(dialogue_.scope, SearchScope::NearGuess);
}

TEST_F(PosedScanMatcherTest, TheAnswerOfTheSensorsComesBackAsThatOfTheRobots)
{
  dialogue_.answer.status = MatchStatus::Converged;
  dialogue_.answer.T_ref_cur = {0.5, 0.3, degToRad(90)};
  const ReferenceMatch match = matcher_.match(scans_, 0, 1, {{}, covariance_});
  EXPECT_EQ(match.reference, 0U);
  EXPECT_TRUE(isNearly(match.T_ref_cur.pose, {1, 0.3, 0}, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(match.result.T_ref_cur, dialogue_.answer.T_ref_cur, 0, 0));
}

TEST_F(PosedScanMatcherTest, EachScanIsPreparedOnceAndTimesAreAdded)
{
  for (int time = 0; time < 5; ++time)
  {
    const ReferenceMatch match = matcher_.match(scans_, 0, 1, {{}, covariance_});
    EXPECT_GE(match.time_s, match.result.times.segmentation_s);
  }
  EXPECT_EQ(dialogue_.prepared, 2);
}
}  // namespace psmks
