/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/OdometryTrack.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
//    y
//    |  ^ second reading, half a second later: the robot has turned to the left
//    |  |
//    o--'-> x
//    first reading, at 10 s
constexpr double kFirst_s = 10, kSecond_s = 10.5;
const Pose2 kFirst{1, 2, 0}, kSecond{1.4, 2.2, degToRad(90)};

OdometryTrack twoReadings()
{
  OdometryTrack track;
  track.add(kFirst_s, kFirst);
  track.add(kSecond_s, kSecond);
  return track;
}

void expectPose(const OdometryTrack& track, double stamp_s, const Pose2& expected)
{
  const auto pose = track.poseAt(stamp_s);
  ASSERT_TRUE(pose) << stamp_s;
  EXPECT_TRUE(isNearly(*pose, expected, 1e-12, 1e-12)) << stamp_s;
}
}  // namespace

TEST(OdometryTrack, BeforeTheFirstReadingNoPoseIsKnown)
{
  EXPECT_FALSE(OdometryTrack().poseAt(kFirst_s));
}

TEST(OdometryTrack, ASingleReadingIsThePoseForASecond)
{
  OdometryTrack track;
  track.add(kFirst_s, kFirst);
  for (const double stamp_s : {kFirst_s - 5, kFirst_s, kFirst_s + OdometryTrack::kMaxAge_s})
    expectPose(track, stamp_s, kFirst);
  EXPECT_FALSE(track.poseAt(kFirst_s + 1.01 * OdometryTrack::kMaxAge_s));
}

TEST(OdometryTrack, AtTheStampOfAReadingThePoseIsThatReading)
{
  expectPose(twoReadings(), kFirst_s, kFirst);
  expectPose(twoReadings(), kSecond_s, kSecond);
}

TEST(OdometryTrack, HalfWayBetweenTwoReadingsIsHalfOfEachCoordinate)
{
  expectPose(twoReadings(), kFirst_s + 0.25, {1.2, 2.1, degToRad(45)});
}

TEST(OdometryTrack, AfterTheLastReadingTheRobotGoesOnAsFast)
{
  // the same motion in the frame of the second reading, whose x axis points along y
  expectPose(twoReadings(), kSecond_s + 0.5, {1.4 - 0.2, 2.2 + 0.4, degToRad(180)});
  EXPECT_FALSE(twoReadings().poseAt(kSecond_s + 1.01 * OdometryTrack::kMaxAge_s));
}

TEST(OdometryTrack, ATimeBeforeBothReadingsGivesTheEarlierOne)
{
  expectPose(twoReadings(), kFirst_s - 1, kFirst);
}

TEST(OdometryTrack, ReadingsFarApartTellNoSpeed)
{
  OdometryTrack track;
  track.add(kFirst_s, kFirst);
  track.add(kFirst_s + 1.01 * OdometryTrack::kMaxAge_s, kSecond);
  expectPose(track, kFirst_s + 0.5, kSecond);
  expectPose(track, kFirst_s + 1.5, kSecond);
}

TEST(OdometryTrack, OfReadingsWithTheSameStampTheLastOneCounts)
{
  OdometryTrack track = twoReadings();
  const Pose2 corrected{1.8, 2, 0};
  track.add(kSecond_s, corrected);
  expectPose(track, kSecond_s, corrected);
  expectPose(track, kFirst_s + 0.25, {1.4, 2, 0});
}

TEST(OdometryTrack, AReadingThatGoesBackInTimeStartsAnew)
{
  OdometryTrack track = twoReadings();
  const Pose2 restarted{0, 0, 0};
  track.add(kFirst_s + 0.25, restarted);
  expectPose(track, kFirst_s + 0.3, restarted);
  track.add(kFirst_s + 0.5, {0.1, 0, 0});
  expectPose(track, kFirst_s + 0.375, {0.05, 0, 0});
}

// The shorter way round: from 175 to -175 degrees are 10 degrees.
TEST(OdometryTrack, HeadingsAreInterpolatedAcrossTheSeam)
{
  OdometryTrack track;
  track.add(kFirst_s, {0, 0, degToRad(175)});
  track.add(kSecond_s, {0, 0, degToRad(-175)});
  expectPose(track, kFirst_s + 0.25, {0, 0, kPi});
}
}  // namespace psmks
