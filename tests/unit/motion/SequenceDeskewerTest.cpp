/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/motion/SequenceDeskewer.h>

namespace psmks
{
namespace
{
const Eigen::Matrix3d kGood = Eigen::Matrix3d::Identity() * 1e-8;

//        |  a wall 2 m ahead, seen at half a degree in two turns of the beam, 0.1 s apart; the
//  o ->  |  robot drives at 1 m/s, so that the second turn sees it 10 cm nearer
//        |
Scan wallAhead(double stamp_s)
{
  Scan scan;
  scan.grid = BeamGrid::centered(degToRad(60), 121);
  scan.stamp_s = stamp_s;
  setTiming({0.1, degToRad(1)}, scan);
  for (int ray = 0; ray < scan.grid.count(); ++ray)
    scan.range_m.push_back((2 - sinceMiddle_s(scan, ray)) / std::cos(scan.grid.bearing_rad(ray)));
  return scan;
}

double worst_m(const Scan& scan)
{
  double worst = 0;
  for (int ray = 2; ray + 2 < scan.grid.count(); ++ray)
  {
    const double ahead_m =
        scan.range_m[static_cast<std::size_t>(ray)] * std::cos(scan.grid.bearing_rad(ray));
    worst = std::max(worst, std::abs(ahead_m - 2));
  }
  return worst;
}

TEST(SequenceDeskewer, MotionsTellTheVelocityOfTheNextScan)
{
  SequenceDeskewer deskewer;
  Scan first = wallAhead(0), second = wallAhead(1);
  deskewer.deskew(first, {}, {});
  EXPECT_EQ(first.range_m, wallAhead(0).range_m) << "no motion is known yet";
  deskewer.deskew(second, {}, {{1, 0, 0}, kGood});
  EXPECT_NEAR(deskewer.measured().x_m_s, 1, 1e-9);
  EXPECT_GT(worst_m(wallAhead(1)), 0.05);
  EXPECT_LT(worst_m(second), 0.002);
}

TEST(SequenceDeskewer, TheScanCorrectsAMotionThatIsUncertain)
{
  SequenceDeskewer deskewer;
  Scan first = wallAhead(0), second = wallAhead(1);
  deskewer.deskew(first, {}, {});
  const Eigen::Matrix3d vague = Eigen::Vector3d(0.25, 0.25, 1e-6).asDiagonal();
  deskewer.deskew(second, {}, {{0.6, 0, 0}, vague});
  EXPECT_LT(worst_m(second), 0.005);
}

TEST(SequenceDeskewer, ARobotThatStandsKeepsItsScans)
{
  SequenceDeskewer deskewer;
  for (int i = 0; i < 3; ++i)
  {
    Scan scan = wallAhead(i);
    deskewer.deskew(scan, {}, {Pose2(), kGood});
    EXPECT_EQ(scan.range_m, wallAhead(i).range_m);
    EXPECT_TRUE(scan.grid == wallAhead(i).grid);
  }
}
}  // namespace
}  // namespace psmks
