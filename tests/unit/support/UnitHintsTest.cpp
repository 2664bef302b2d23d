/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/UnitHints.h>
#include <gtest/gtest.h>
#include <tests/support/Says.h>

#include <cmath>

namespace psmks
{
namespace
{
/** What a log states one metre, one radian and the metre of a range as. */
struct Units
{
  double odometry = 1, heading = 1, ranges = 1;
};

/** A drive of 20 m along a square with turns of half a second, at ranges of 4 m, five scans a
 * second; the path of the scans is right. */
std::vector<PosedScan> drive(const Units& units, double pathScale = 1)
{
  std::vector<PosedScan> scans;
  Pose2 T_world_robot;
  double heading_rad = 0;
  for (int i = 0; i < 120; ++i)
  {
    const bool turns = i % 25 > 21;
    T_world_robot = T_world_robot * (turns ? Pose2{0, 0, kPi / 6} : Pose2{0.2, 0, 0});
    heading_rad += turns ? kPi / 6 : 0;
    PosedScan scan;
    scan.scan.grid = BeamGrid::centered(kPi, 61);
    scan.scan.range_m.assign(61, 4 * units.ranges);
    scan.scan.stamp_s = 100 + 0.2 * i;
    scan.T_world_robot.pose = T_world_robot;
    scan.T_world_robot.pose.x_m *= pathScale;
    scan.T_world_robot.pose.y_m *= pathScale;
    scan.T_world_odometry = {T_world_robot.x_m * units.odometry, T_world_robot.y_m * units.odometry,
                             wrapAngle(heading_rad * units.heading)};
    scans.push_back(scan);
  }
  return scans;
}

void expectHint(const std::vector<std::string>& hints, const std::string& words)
{
  ASSERT_EQ(hints.size(), 1u) << testing::PrintToString(hints);
  EXPECT_TRUE(test::says(hints[0], {words})) << hints[0];
}

/** The path of the drive as a truth, scaled. */
std::vector<CommonPose> common(double scale)
{
  std::vector<CommonPose> poses;
  for (const PosedScan& scan : drive({}))
  {
    const Pose2 pose = scan.T_world_robot.pose;
    poses.push_back(
        {scan.stamp_s(), pose, {scale * pose.x_m, scale * pose.y_m, pose.phi_rad}, true});
  }
  return poses;
}

TEST(UnitHints, AnOrdinaryDriveHasNone) { EXPECT_TRUE(unitHints(drive({})).empty()); }

TEST(UnitHints, LengthsInOtherUnitsAreSeen)
{
  for (const double unit : {100.0, 1000.0})
  {
    expectHint(unitHints(drive({unit, 1, 1})), "the odometry drives at");
    expectHint(unitHints(drive({1, 1, unit})), "half of the ranges are above");
    EXPECT_EQ(unitHints(drive({unit, 1, unit})).size(), 2u);
  }
}

TEST(UnitHints, HeadingsInDegreesAreSeen)
{
  expectHint(unitHints(drive({1, radToDeg(1), 1})), "are its headings in degrees?");
}

TEST(UnitHints, APathThatIsFarFromThatOfTheOdometryIsTold)
{
  expectHint(unitHints(drive({}, 0.1)), "the path of the scans is ");
  EXPECT_TRUE(unitHints(drive({}, 0.8)).empty()) << "slip";
}

TEST(UnitHints, WithoutScansOrOdometryThereAreNone)
{
  EXPECT_TRUE(unitHints(std::vector<PosedScan>()).empty());
  EXPECT_TRUE(unitHints(std::vector<CommonPose>()).empty());
  auto scans = drive({});
  for (PosedScan& scan : scans) scan.T_world_odometry = {};
  EXPECT_TRUE(unitHints(scans).empty());
}

TEST(UnitHints, ATruthInOtherUnitsIsSeen)
{
  expectHint(unitHints(common(1000)), "is the first in millimetres?");
  expectHint(unitHints(common(0.01)), "is the second in centimetres?");
  EXPECT_TRUE(unitHints(common(1.2)).empty());
  EXPECT_TRUE(unitHints(common(10)).empty()) << "no unit";
}

TEST(StampHint, NamesTheUnitOfTheOtherStamps)
{
  const Trajectory seconds{{1.7e9, {}}}, nanoseconds{{1.7e18, {}}}, others{{1.6e9, {}}};
  EXPECT_EQ(stampHint(seconds, nanoseconds), ", are its stamps in nanoseconds?");
  EXPECT_EQ(stampHint(nanoseconds, seconds),
            ", are its stamps in seconds and the other's in nanoseconds?");
  EXPECT_EQ(stampHint(seconds, others), "");
}
}  // namespace
}  // namespace psmks
