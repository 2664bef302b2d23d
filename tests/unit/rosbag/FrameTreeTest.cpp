/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/rosbag/FrameTree.h>

namespace psmks
{
namespace
{
Eigen::Isometry3d planar(double x_m, double y_m, double phi_rad)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.rotate(Eigen::AngleAxisd(phi_rad, Eigen::Vector3d::UnitZ()));
  T.pretranslate(Eigen::Vector3d(x_m, y_m, 0));
  return T;
}

//  odom ~~> base_footprint --> base_link --> laser      ~~> moves if the robot drives
FrameTree robot(bool drives)
{
  FrameTree tree;
  tree.add({0, "base_link", "laser", planar(0.2, 0, degToRad(90))});
  tree.add({0, "base_footprint", "base_link", planar(0.1, 0, 0)});
  for (int step = 0; step < 3; ++step)
    tree.add({0.1 * step, "odom", "base_footprint", planar(7 + (drives ? 0.5 * step : 0), 0, 0)});
  return tree;
}
}  // namespace

TEST(FrameTree, TheRobotIsWhatMovesAndCarriesTheSensor)
{
  const FrameTree tree = robot(true);
  EXPECT_EQ(tree.robotOf("laser"), "base_footprint");
  const auto motion = tree.motionOf("base_footprint");
  ASSERT_EQ(motion.size(), 3U);
  EXPECT_DOUBLE_EQ(motion[2].T_parent_child.x_m, 8);
  EXPECT_DOUBLE_EQ(motion[2].stamp_s, 0.2);
}

TEST(FrameTree, ARobotThatStandsIsKnownByItsUsualName)
{
  const FrameTree tree = robot(false);
  EXPECT_EQ(tree.robotOf("laser"), "base_footprint");
  EXPECT_TRUE(tree.motionOf("base_footprint").empty());
  EXPECT_EQ(FrameTree().robotOf("laser"), "laser");
}

TEST(FrameTree, TheMountingIsTheChainOfTransforms)
{
  const auto T = robot(true).poseOf("laser", "base_footprint");
  ASSERT_TRUE(T.has_value());
  EXPECT_TRUE(T->isApprox(planar(0.3, 0, degToRad(90)), 1e-12));
  EXPECT_TRUE(robot(true).poseOf("laser", "laser")->isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(robot(true).poseOf("laser", "wheel").has_value());
}

TEST(FrameTree, FramesThatGoInACircleEndTheSearch)
{
  FrameTree tree;
  tree.add({0, "a", "b", planar(1, 0, 0)});
  tree.add({0, "b", "a", planar(1, 0, 0)});
  EXPECT_FALSE(tree.poseOf("a", "c").has_value());
  EXPECT_EQ(tree.robotOf("a"), "a");
}
}  // namespace psmks
