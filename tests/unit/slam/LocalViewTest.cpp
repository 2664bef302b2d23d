/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/slam/LocalView.h>
#include <tests/support/Scenes.h>

#include <cmath>

namespace psmks
{
namespace
{
//    +-----------------+      a room of 12 x 6 m; scanners that see half a circle look to the right
//    | 0> 1>  o     <2 |      from 0 and 1 and to the left from 2
//    +-----------------+
class LocalViewTest : public testing::Test
{
 protected:
  LocalViewTest()
  {
    for (const Pose2& pose : {Pose2{-4, 0, 0}, Pose2{-2, 0, 0}, Pose2{4, 0, kPi}})
      scans_.push_back(scanFrom(pose));
  }

  static PosedScan scanFrom(const Pose2& pose)
  {
    PosedScan posed;
    posed.scan = castScan(box({0, 0}, 12, 6), pose, BeamGrid::centered(kPi, 361));
    posed.T_world_robot.pose = pose;
    return posed;
  }

  static int returnsOf(const Scan& view)
  {
    int returns = 0;
    for (int ray = 0; ray < view.grid.count(); ++ray) returns += isReturn(view, ray) ? 1 : 0;
    return returns;
  }

  /** The largest error of a range of the view, as seen by a scanner all round at its place. */
  static double largestError_m(const Scan& view, const std::vector<Wall>& walls, const Pose2& pose)
  {
    const Scan truth = castScan(walls, pose, view.grid);
    double largest_m = 0;
    for (int ray = 0; ray < view.grid.count(); ++ray)
      if (isReturn(view, ray))
        largest_m = std::max(largest_m, std::abs(view.range_m[static_cast<std::size_t>(ray)] -
                                                 truth.range_m[static_cast<std::size_t>(ray)]));
    return largest_m;
  }

  std::vector<PosedScan> scans_;
};
}  // namespace

TEST_F(LocalViewTest, ShowsAllRoundWhatScansThatLookBothWaysSaw)
{
  const Pose2 here{0, 0.5, degToRad(30)};
  const Scan view = localView(scans_, {0, 1, 2}, here);
  EXPECT_EQ(view.grid.count(), 720);
  EXPECT_GT(returnsOf(view), 700);
  EXPECT_LT(largestError_m(view, box({0, 0}, 12, 6), here), 0.05) << "at a corner";
}

TEST_F(LocalViewTest, OfOneScanShowsItsHalf)
{
  const Scan view = localView(scans_, {0}, scans_[0].T_world_robot.pose);
  EXPECT_NEAR(returnsOf(view), 361, 2);
  EXPECT_LT(largestError_m(view, box({0, 0}, 12, 6), scans_[0].T_world_robot.pose), 1e-3);
}

TEST_F(LocalViewTest, TheFirstScanThatSeesSomethingAlongARayDecides)
{
  scans_[1].T_world_robot.pose.y_m += 0.2;  // the second scan is 20 cm off
  const Pose2 here = scans_[0].T_world_robot.pose;
  const Scan view = localView(scans_, {0, 1}, here);
  EXPECT_LT(largestError_m(view, box({0, 0}, 12, 6), here), 1e-3);
  const Scan other = localView(scans_, {1, 0}, here);
  EXPECT_GT(largestError_m(other, box({0, 0}, 12, 6), here), 0.15);
}

TEST_F(LocalViewTest, AScannerThatIsMountedElsewhereSeesTheSame)
{
  PosedScan turned = scanFrom({1, 1, kPi / 2});
  turned.T_robot_sensor = {0.5, 0, kPi / 2};
  turned.T_world_robot.pose = Pose2{1, 1, kPi / 2} * turned.T_robot_sensor.inverse();
  const Pose2 here{1, 1, 0};
  const Scan view = localView({turned}, {0}, here);
  EXPECT_GT(returnsOf(view), 350);
  EXPECT_LT(largestError_m(view, box({0, 0}, 12, 6), here), 1e-3);
}

//      |  x   the scan was taken at x, to the right of a wall: from o on its left only the back of
//   o  |      what it saw is to be seen, which nobody has looked at
TEST_F(LocalViewTest, TheBackOfASurfaceIsNoReturn)
{
  PosedScan beyond;
  beyond.T_world_robot.pose = {2, 0, kPi};
  beyond.scan =
      castScan({{{0, -1}, {0, 1}}}, beyond.T_world_robot.pose, BeamGrid::centered(kPi / 2, 91));
  EXPECT_GT(returnsOf(localView({beyond}, {0}, {1, 0, 0})), 50);
  EXPECT_EQ(returnsOf(localView({beyond}, {0}, {-2, 0, 0})), 0);
}

TEST_F(LocalViewTest, OfNoScansIsEmpty)
{
  EXPECT_EQ(localView(scans_, {}, {}).grid.count(), 0);
  PosedScan blind = scans_[0];
  blind.scan.range_m.assign(blind.scan.range_m.size(), 0);
  EXPECT_EQ(returnsOf(localView({blind}, {0}, {})), 0);
}
}  // namespace psmks
