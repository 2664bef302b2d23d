/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Summary.h>
#include <gtest/gtest.h>

namespace psmks
{
namespace
{
std::vector<PosedScan> scansAt(const std::vector<Pose2>& poses)
{
  std::vector<PosedScan> scans;
  for (const Pose2& pose : poses)
  {
    scans.emplace_back();
    scans.back().T_world_robot.pose = pose;
  }
  return scans;
}
}  // namespace

TEST(Summary, TheScatterOfARobotThatStandsIsNoWay)
{
  std::vector<Pose2> poses;
  for (int i = 0; i < 1000; ++i) poses.push_back({i % 2 == 0 ? 0 : 0.01, 0, 0});
  EXPECT_EQ(summarise(scansAt(poses)).pathLength_m, 0);
}

TEST(Summary, AWayIsMeasuredHoweverShortItsSteps)
{
  std::vector<Pose2> poses;
  for (int i = 0; i <= 1000; ++i) poses.push_back({0.003 * i, 0, 0});
  EXPECT_NEAR(summarise(scansAt(poses)).pathLength_m, 3, 0.1);
}
}  // namespace psmks
