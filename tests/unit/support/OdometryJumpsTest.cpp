/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/OdometryJumps.h>
#include <gtest/gtest.h>

#include <cmath>

namespace psmks
{
namespace
{
/** A robot that moves by 10 cm a scan, with odometry that says so but for one motion. */
std::vector<PosedScan> drive(std::size_t jumpsAt, const Pose2& jump)
{
  std::vector<PosedScan> scans(6);
  for (std::size_t s = 1; s < scans.size(); ++s)
  {
    ReferenceMatch match;
    match.result.status = MatchStatus::Converged;
    scans[s].decideBy(match);
    scans[s].T_last_robot.pose = {0.1, 0, 0};
    scans[s].T_world_odometry =
        scans[s - 1].T_world_odometry * (s == jumpsAt ? jump : Pose2{0.1, 0, 0});
  }
  return scans;
}
}  // namespace

TEST(OdometryJumps, ARestartOfTheOdometryIsOne)
{
  const auto jumps = odometryJumps(drive(3, {-4, 2, 0}));
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_EQ(jumps[0].scan, 3U);
  EXPECT_NEAR(jumps[0].distance_m, std::hypot(4.1, 2), 1e-12);
  EXPECT_EQ(odometryJumps(drive(3, {0.1, 0, kPi})).size(), 1U);
}

TEST(OdometryJumps, SlippingWheelsAreNone)
{
  EXPECT_TRUE(odometryJumps(drive(3, {0.9, 0, degToRad(40)})).empty());
}

TEST(OdometryJumps, WhereNoMatchTellsTheMotionNoneIsFound)
{
  auto scans = drive(3, {-4, 2, 0});
  scans[3].matches.clear();
  EXPECT_TRUE(odometryJumps(scans).empty());
}

TEST(OdometryJumps, ALogWithoutOdometryHasNone)
{
  auto scans = drive(3, {-4, 2, 0});
  for (PosedScan& scan : scans)
  {
    scan.T_world_odometry = Pose2();
    scan.T_last_robot.pose = {2, 0, 0};
  }
  EXPECT_TRUE(odometryJumps(scans).empty());
}
}  // namespace psmks
