/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/KeyframeMap.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
namespace
{
//    +-----------+-----------+      two rooms of 8 x 6 m, with a door between them; x from -4 to 12
//    |     3     |           |
//    | 0   1   2 = 4         |      keyframes 0, 1, 2 in a row 1.5 m apart, 3 above 1, 4 behind the
//    |           |           |      door
//    +-----------+-----------+
std::vector<Wall> twoRooms()
{
  std::vector<Wall> walls = box({4, 0}, 16, 6);
  walls.push_back({{4, -3}, {4, -0.4}});
  walls.push_back({{4, 0.4}, {4, 3}});
  return walls;
}

const std::vector<Pose2> kKeyframes{
    {-1.5, 0, 0}, {0, 0, 0}, {1.5, 0, degToRad(20)}, {0, 1.5, 0}, {7, 0, 0}};

class KeyframeMapTest : public testing::Test
{
 protected:
  KeyframeMapTest()
  {
    for (const Pose2& pose : kKeyframes) scans_.push_back(scanAt(pose));
  }

  /** A scan from its true pose, which is also the pose that it is said to have. */
  static PosedScan scanAt(const Pose2& pose)
  {
    PosedScan posed;
    posed.scan = castScan(twoRooms(), pose, BeamGrid::centered(2 * kPi, 360));
    posed.T_world_robot.pose = pose;
    return posed;
  }

  static PosedScan scanSaidToBeAt(const Pose2& said, const Pose2& truth)
  {
    PosedScan posed = scanAt(truth);
    posed.T_world_robot.pose = said;
    return posed;
  }

  ReferenceMatch linkFrom(std::size_t reference, const Pose2& T_ref_cur) const
  {
    ReferenceMatch link;
    link.reference = reference;
    link.T_ref_cur.pose = T_ref_cur;
    link.T_ref_cur.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-7).asDiagonal();
    link.information = link.T_ref_cur.covariance.inverse();
    return link;
  }

  Pose2 between(std::size_t a, std::size_t b) const
  {
    return kKeyframes[a].inverse() * kKeyframes[b];
  }

  /** A map of the first keyframes, each linked to the one before by the truth. */
  KeyframeMap mapOf(std::size_t keyframes, const ReferenceOptions& options = {})
  {
    KeyframeMap map{ReferencePolicy(options)};
    map.add(scans_, 0, {});
    for (std::size_t k = 1; k < keyframes; ++k)
      map.add(scans_, k, {linkFrom(k - 1, between(k - 1, k))});
    map.standAt(0, {});
    return map;
  }

  static std::vector<std::size_t> keyframesOf(
      const std::vector<KeyframeMap::ExpectedKeyframe>& expected)
  {
    std::vector<std::size_t> keyframes;
    for (const KeyframeMap::ExpectedKeyframe& one : expected) keyframes.push_back(one.keyframe);
    return keyframes;
  }

  using Keyframes = std::vector<std::size_t>;

  std::vector<PosedScan> scans_;
};
}  // namespace

TEST_F(KeyframeMapTest, AnEmptyMapKnowsNothing)
{
  const KeyframeMap map{ReferencePolicy({})};
  EXPECT_FALSE(map.nearest(scans_, scans_[0]));
  EXPECT_TRUE(map.around(scans_, scans_[0]).empty());
  EXPECT_TRUE(map.possiblePlaces().empty());
  EXPECT_TRUE(map.localMap(0, 1).empty());
  EXPECT_FALSE(map.covers(scans_, scans_[0]));
}

TEST_F(KeyframeMapTest, TheNearestKeyframeIsNearestInPlaceAndHeading)
{
  const KeyframeMap map = mapOf(5);
  EXPECT_EQ(map.nearest(scans_, scanAt({-0.9, 0, 0})), 0U);
  EXPECT_EQ(map.nearest(scans_, scanAt({0.6, 0, 0})), 1U);
  EXPECT_EQ(map.nearest(scans_, scanAt({0.9, 0, degToRad(20)})), 2U);
  // 0.7 m from keyframe 1 and turned by 30 degrees, 0.8 m from keyframe 2 and turned by 10
  EXPECT_EQ(map.nearest(scans_, scanAt({0.7, 0, degToRad(30)})), 2U);
}

TEST_F(KeyframeMapTest, AKeyframeOnTheOtherSideOfAWallSawTooLittle)
{
  // 2.1 m from keyframe 4 and 3.5 m from keyframe 2, but 4 sees another room
  KeyframeMap map = mapOf(5);
  const PosedScan besideTheWall = scanAt({3.6, 2.5, 0});
  ASSERT_LT((besideTheWall.T_world_robot.pose.translation() - kKeyframes[4].translation()).norm(),
            4.3);
  const auto around = keyframesOf(map.around(scans_, besideTheWall));
  EXPECT_EQ(std::count(around.begin(), around.end(), 4U), 0);
  EXPECT_FALSE(around.empty());
}

TEST_F(KeyframeMapTest, KeyframesOutOfReachAreNotAround)
{
  const KeyframeMap map = mapOf(5);
  EXPECT_EQ(keyframesOf(map.around(scans_, scanAt({-1.2, 0, 0}))), (Keyframes{0, 1, 3, 2}));
  EXPECT_TRUE(map.around(scans_, scanAt({-1.2, 0, degToRad(100)})).empty());
  const auto views = map.around(scans_, scanAt({-1.2, 0, 0}));
  EXPECT_TRUE(isNearly(views[0].T_keyframe_cur, {0.3, 0, 0}, 1e-12, 1e-12));
}

TEST_F(KeyframeMapTest, WithoutAMapOnlyTheLastKeyframesAreAround)
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Keyframe;
  options.keyframeWindow = 2;
  const KeyframeMap map = mapOf(4, options);
  EXPECT_EQ(keyframesOf(map.around(scans_, scanAt({-1.2, 0, 0}))), (Keyframes{3, 2}));
}

TEST_F(KeyframeMapTest, CoversWhatANearKeyframeSaw)
{
  const KeyframeMap map = mapOf(1);  // a keyframe a metre or 30 degrees away covers nothing
  EXPECT_TRUE(map.covers(scans_, scanAt({-0.6, 0, degToRad(20)})));
  EXPECT_FALSE(map.covers(scans_, scanAt({-0.4, 0, 0})));
  EXPECT_FALSE(map.covers(scans_, scanAt({-1.5, 0, degToRad(40)})));
  const PosedScan elsewhere = scanSaidToBeAt({-1.5, 0, 0}, {9, 1, 0});
  EXPECT_FALSE(map.covers(scans_, elsewhere)) << "it shows another room";
}

//    0 --- 1     the robot stands at 1; the link between the two leaves 0.5 m and 5 degrees open
class UncertainWay : public KeyframeMapTest
{
 protected:
  UncertainWay()
  {
    ReferenceMatch link = linkFrom(0, between(0, 1));
    link.T_ref_cur.covariance = Eigen::Vector3d(0.25, 0.25, 0.0076).asDiagonal();
    link.information = link.T_ref_cur.covariance.inverse();
    map_.add(scans_, 0, {});
    map_.add(scans_, 1, {link});
  }

  KeyframeMap map_{ReferencePolicy({})};
};

TEST_F(UncertainWay, APlaceThatTheGraphDoesNotKnowIsSearchedAndServesForNothingElse)
{
  map_.standAt(1, {});
  const auto places = map_.possiblePlaces();
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].keyframe, 0U);
  EXPECT_TRUE(isNearly(places[0].T_keyframe_cur.pose, between(0, 1), 1e-9, 1e-9));
  EXPECT_NEAR(std::sqrt(places[0].T_keyframe_cur.covariance(2, 2)), degToRad(5), degToRad(0.1));
  EXPECT_EQ(keyframesOf(map_.around(scans_, scanAt({-1.2, 0, 0}))), Keyframes{1});
  EXPECT_EQ(map_.nearest(scans_, scanAt({-1.2, 0, 0})), 1U);
  EXPECT_FALSE(map_.covers(scans_, scanAt({-1.4, 0, 0})));
}

TEST_F(UncertainWay, FromBeyondTheReachAPlaceIsNotSearched)
{
  map_.standAt(1, {{3.9, 0, 0}, Eigen::Matrix3d::Zero()});  // 5.4 m from 0; the reach is 4 + 1.5 m
  EXPECT_EQ(map_.possiblePlaces().size(), 1U);
  map_.standAt(1, {{4.5, 0, 0}, Eigen::Matrix3d::Zero()});
  EXPECT_TRUE(map_.possiblePlaces().empty());
}

TEST_F(UncertainWay, OnlyAKeyframeTellsWhereTheRobotIs)
{
  map_.standAt(1, {});
  map_.standAt(3, {});  // no keyframe: the robot stays where it was
  EXPECT_EQ(map_.possiblePlaces().size(), 1U);
}

TEST_F(UncertainWay, ALocalMapIsOfKeyframesThatFitEachOther)
{
  map_.add(scans_, 2, {linkFrom(1, between(1, 2))});
  EXPECT_EQ(map_.localMap(1, 0.04), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(map_.localMap(0, 0.04), std::vector<std::size_t>{0});
  EXPECT_EQ(map_.localMap(0, 2).size(), 3U);
  EXPECT_TRUE(map_.localMap(0, 0).empty());
}

TEST_F(KeyframeMapTest, WhatIsKnownIsNotSearched)
{
  const KeyframeMap map = mapOf(4);
  EXPECT_TRUE(map.possiblePlaces().empty());
}

TEST_F(KeyframeMapTest, LinksThatAgreeMoveNothing)
{
  mapOf(5);
  for (std::size_t k = 0; k < kKeyframes.size(); ++k)
    EXPECT_TRUE(isNearly(scans_[k].T_world_robot.pose, kKeyframes[k], 0, 0)) << k;
}

TEST_F(KeyframeMapTest, ASmallContradictionWaitsForTheEnd)
{
  KeyframeMap map = mapOf(2);
  Pose2 off = between(1, 2);
  off.x_m += 0.008;
  map.add(scans_, 2, {linkFrom(1, off)});
  EXPECT_TRUE(isNearly(scans_[2].T_world_robot.pose, kKeyframes[2], 0, 0));
  map.optimise(scans_);
  EXPECT_TRUE(isNearly(scans_[2].T_world_robot.pose, kKeyframes[1] * off, 1e-5, 1e-5));
}

TEST_F(KeyframeMapTest, AGrossContradictionMovesTheKeyframesAtOnce)
{
  KeyframeMap map = mapOf(2);
  Pose2 off = between(1, 2);
  off.x_m += 0.06;
  map.add(scans_, 2, {linkFrom(1, off)});
  EXPECT_TRUE(isNearly(scans_[2].T_world_robot.pose, kKeyframes[1] * off, 1e-4, 1e-4));
  EXPECT_TRUE(isNearly(scans_[0].T_world_robot.pose, kKeyframes[0], 0, 0)) << "the first one stays";
}

// A heading that is off by 2 degrees moves what is 2 m away by 7 cm.
TEST_F(KeyframeMapTest, AHeadingCountsByWhatItMoves)
{
  KeyframeMap map = mapOf(2);
  Pose2 turned = between(1, 2);
  turned.phi_rad += degToRad(2);
  map.add(scans_, 2, {linkFrom(1, turned)});
  EXPECT_TRUE(isNearly(scans_[2].T_world_robot.pose, kKeyframes[1] * turned, 1e-4, 1e-4));
}

TEST_F(KeyframeMapTest, ALinkFromAScanThatIsNoKeyframeIsLeftOut)
{
  KeyframeMap map = mapOf(2);
  map.add(scans_, 2, {linkFrom(1, between(1, 2)), linkFrom(3, {5, 5, 1})});
  map.optimise(scans_);
  EXPECT_TRUE(isNearly(scans_[2].T_world_robot.pose, kKeyframes[2], 1e-9, 1e-9));
}

//     0 --- 1     two matches put 1 at 1.50 m and at 1.54 m of 0. The first is ten times as certain
//                 as the second, but what is added to both makes them nearly alike.
TEST_F(KeyframeMapTest, WhatIsAddedToLinksDecidesHowTheyShareAnError)
{
  ReferenceMatch sure = linkFrom(0, {1.50, 0, 0}), unsure = linkFrom(0, {1.54, 0, 0});
  sure.information = Eigen::Vector3d(1e6, 1e6, 1e6).asDiagonal();
  unsure.information = Eigen::Vector3d(1e4, 1e4, 1e6).asDiagonal();
  const auto positionWith = [&](double linkSigma_m)
  {
    ReferenceOptions options;
    options.linkSigma_m = linkSigma_m;
    KeyframeMap map{ReferencePolicy(options)};
    std::vector<PosedScan> scans{scans_[0], scans_[1]};
    map.add(scans, 0, {});
    map.add(scans, 1, {sure, unsure});
    map.optimise(scans);
    return scans[1].T_world_robot.pose.x_m - scans[0].T_world_robot.pose.x_m;
  };
  EXPECT_NEAR(positionWith(0), 1.500, 0.003);
  EXPECT_NEAR(positionWith(0.1), 1.520, 0.003);
}
}  // namespace psmks
