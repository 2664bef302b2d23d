/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/PlaceSearch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
PosedScan scanAt(const Pose2& T_world_robot, const Pose2& T_robot_sensor)
{
  PosedScan posed;
  posed.T_robot_sensor = T_robot_sensor;
  posed.scan =
      castScan(officeRoom(), T_world_robot * T_robot_sensor, BeamGrid::centered(2 * kPi, 360));
  return posed;
}
}  // namespace

TEST(PlaceSearch, FindsAPlaceThatDriftHasMoved)
{
  const Pose2 mounting{0.3, 0.1, degToRad(10)};
  const Pose2 T_ref_cur{0.5, -0.2, degToRad(12)};
  const PosedScan reference = scanAt({}, mounting), current = scanAt(T_ref_cur, mounting);
  const Pose2 drifted{T_ref_cur.x_m + 1.1, T_ref_cur.y_m - 0.9, T_ref_cur.phi_rad + degToRad(9)};
  const SharedPlace place = findSharedPlace(reference, current, drifted, {1.6, degToRad(12)});
  EXPECT_GT(place.overlap, 0.9);
  EXPECT_LT((place.T_ref_cur.translation() - T_ref_cur.translation()).norm(), 0.4);
  EXPECT_LT(std::abs(wrapAngle(place.T_ref_cur.phi_rad - T_ref_cur.phi_rad)), degToRad(5));
}

TEST(PlaceSearch, ReachesAsFarAsTheDriftAndItsLastStep)
{
  // both scans are the same, and one is expected 3 m beside the other; steps are 0.4 m
  const PosedScan reference = scanAt({}, {}), current = scanAt({}, {});
  const Pose2 drifted{3, 0, 0};
  EXPECT_GT(findSharedPlace(reference, current, drifted, {2.9, 0}).overlap, 0.9);
  const SharedPlace tooNear = findSharedPlace(reference, current, drifted, {1, 0});
  EXPECT_LT(tooNear.overlap, 0.9);
  EXPECT_LE((tooNear.T_ref_cur.translation() - drifted.translation()).norm(), 1.2 + 1e-9);
}

TEST(PlaceSearch, WhereNothingIsSharedItStaysAtTheExpectedPose)
{
  PosedScan blind = scanAt({}, {});
  blind.scan.range_m.assign(blind.scan.range_m.size(), 0);
  const Pose2 expected{1, 2, 0.5};
  const SharedPlace place = findSharedPlace(scanAt({}, {}), blind, expected, {1, degToRad(10)});
  EXPECT_EQ(place.overlap, 0);
  EXPECT_TRUE(isNearly(place.T_ref_cur, expected, 0, 0));
}

TEST(PlaceSearch, WithoutDriftThePlaceIsTheExpectedOne)
{
  const PosedScan here = scanAt({}, {});
  const SharedPlace place = findSharedPlace(here, here, {0.1, 0, 0}, {});
  EXPECT_EQ(place.T_ref_cur.x_m, 0.1);
  EXPECT_GT(place.overlap, 0.9);
}
}  // namespace psmks
