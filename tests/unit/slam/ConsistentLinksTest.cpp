/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/ConsistentLinks.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
//     k0      k1      k2          keyframes 2 m apart that look to different sides,
//
//                 scan            and a scan that the map has a metre below them
class ConsistentLinksTest : public testing::Test
{
 protected:
  ConsistentLinksTest()
  {
    for (int k = 0; k < 3; ++k)
    {
      PosedScan keyframe;
      keyframe.T_world_robot.pose = {2.0 * k, 0, degToRad(120.0 * k)};
      keyframes_.push_back(keyframe);
    }
    scan_.T_world_robot.pose = {3, -1, degToRad(30)};
  }

  /** A match that says that the scan is displaced from where the map has it, in its own axes. */
  ReferenceMatch matchBy(std::size_t keyframe, const Pose2& correction) const
  {
    ReferenceMatch match;
    match.reference = keyframe;
    match.T_ref_cur.pose =
        keyframes_[keyframe].T_world_robot.pose.inverse() * scan_.T_world_robot.pose * correction;
    return match;
  }

  std::vector<std::size_t> keptOf(const std::vector<ReferenceMatch>& found) const
  {
    std::vector<std::size_t> kept;
    for (const ReferenceMatch& match : consistentLinks(keyframes_, scan_, found))
      kept.push_back(match.reference);
    return kept;
  }

  using Kept = std::vector<std::size_t>;

  std::vector<PosedScan> keyframes_;
  PosedScan scan_;
};
}  // namespace

TEST_F(ConsistentLinksTest, AMatchThatAgreesWithTheMapNeedsNoOther)
{
  EXPECT_EQ(keptOf({matchBy(1, {0.03, -0.03, degToRad(0.9)})}), Kept{1});
}

TEST_F(ConsistentLinksTest, AMatchThatStandsAloneIsDropped)
{
  EXPECT_EQ(keptOf({matchBy(1, {0.06, 0, 0})}), Kept{});
  EXPECT_EQ(keptOf({matchBy(1, {0, 0, degToRad(1.1)})}), Kept{});
  EXPECT_EQ(keptOf({matchBy(0, {1, 0, 0}), matchBy(2, {0, 1, 0})}), Kept{});
}

TEST_F(ConsistentLinksTest, MatchesThatMoveTheScanAlikeConfirmEachOther)
{
  const Pose2 drift{0.8, -0.5, degToRad(5)}, almost{0.82, -0.52, degToRad(5.5)};
  EXPECT_EQ(keptOf({matchBy(0, drift), matchBy(2, almost)}), (Kept{0, 2}));
}

TEST_F(ConsistentLinksTest, AWrongMatchAmongRightOnesIsDroppedAndTheOrderStays)
{
  const Pose2 drift{0.8, -0.5, degToRad(5)};
  EXPECT_EQ(keptOf({matchBy(2, drift), matchBy(1, {-1, 0, 0}), matchBy(0, drift)}), (Kept{2, 0}));
}

TEST_F(ConsistentLinksTest, HeadingsAreComparedAcrossHalfATurn)
{
  EXPECT_EQ(keptOf({matchBy(0, {0, 0, degToRad(179.8)}), matchBy(1, {0, 0, degToRad(-179.8)})}),
            (Kept{0, 1}));
}

TEST_F(ConsistentLinksTest, WithoutMatchesThereAreNoLinks) { EXPECT_EQ(keptOf({}), Kept{}); }
}  // namespace psmks
