/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/OdometryTrack.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
/** Rounding alone. */
constexpr double kExact = 1e-12;

//  y
//  |    x 10.2 s   A robot drives along the diagonal and turns to the left:
//  |  x 10.0 s     readings every 0.2 s, 0.1 m and 10 degrees apart.
//  +------- x
class OdometryTrackTest : public testing::Test
{
 protected:
  void addBoth()
  {
    track_.add(10.0, first_);
    track_.add(10.2, first_ * step_);
  }

  /** After a share of the step beyond the first reading: its parts grow in proportion to time. */
  Pose2 after(double steps) const
  {
    return first_ * step_ * Pose2{(steps - 1) * step_.x_m, 0, (steps - 1) * step_.phi_rad};
  }

  OdometryTrack track_;
  const Pose2 first_{1, 1, degToRad(45)}, step_{0.1, 0, degToRad(10)};
};
}  // namespace

TEST_F(OdometryTrackTest, BeforeTheFirstReadingNothingIsKnown) { EXPECT_FALSE(track_.poseAt(10)); }

TEST_F(OdometryTrackTest, AtAReadingItIsThatReading)
{
  addBoth();
  EXPECT_TRUE(isNearly(*track_.poseAt(10.2), first_ * step_, kExact, kExact));
}

TEST_F(OdometryTrackTest, BetweenReadingsItIsInterpolated)
{
  addBoth();
  EXPECT_TRUE(isNearly(*track_.poseAt(10.15), after(0.75), kExact, kExact));
}

TEST_F(OdometryTrackTest, AfterTheLastReadingTheSpeedIsKept)
{
  addBoth();
  EXPECT_TRUE(isNearly(*track_.poseAt(10.3), after(1.5), kExact, kExact));
}

TEST_F(OdometryTrackTest, BeforeTheLastButOneItStays)
{
  addBoth();
  EXPECT_TRUE(isNearly(*track_.poseAt(9), after(0), kExact, kExact));
}

TEST_F(OdometryTrackTest, OneReadingStands)
{
  track_.add(10, first_);
  EXPECT_TRUE(isNearly(*track_.poseAt(10.5), first_, 0, 0));
}

TEST_F(OdometryTrackTest, AnOldReadingSaysNothingOfThePresent)
{
  addBoth();
  EXPECT_TRUE(track_.poseAt(10.2 + OdometryTrack::kMaxAge_s - 1e-6));
  EXPECT_FALSE(track_.poseAt(10.2 + OdometryTrack::kMaxAge_s + 1e-6));
}

// A speed over more than a second is none of the present one.
TEST_F(OdometryTrackTest, ReadingsFarApartAreNotInterpolated)
{
  track_.add(10, first_);
  track_.add(10 + 2 * OdometryTrack::kMaxAge_s, first_ * step_);
  EXPECT_TRUE(isNearly(*track_.poseAt(11.5), first_ * step_, 0, 0));
  EXPECT_TRUE(isNearly(*track_.poseAt(12.5), first_ * step_, 0, 0));
}

TEST_F(OdometryTrackTest, OfReadingsThatShareAStampTheLastOneCounts)
{
  track_.add(10.0, first_);
  track_.add(10.2, {7, 7, 7});
  track_.add(10.2, first_ * step_);
  EXPECT_TRUE(isNearly(*track_.poseAt(10.1), after(0.5), kExact, kExact));
}

TEST_F(OdometryTrackTest, WhereTimeRunsBackNothingIsInterpolated)
{
  track_.add(10.2, {7, 7, 1});
  track_.add(10.0, first_);
  EXPECT_TRUE(isNearly(*track_.poseAt(10.0), first_, 0, 0));
  EXPECT_TRUE(isNearly(*track_.poseAt(10.1), first_, 0, 0));
}

// The shorter way round: from 175 to -175 degrees are 10 degrees.
TEST_F(OdometryTrackTest, HeadingsAreInterpolatedAcrossTheSeam)
{
  track_.add(10.0, {0, 0, degToRad(175)});
  track_.add(10.2, {0, 0, degToRad(-175)});
  EXPECT_TRUE(isNearly(*track_.poseAt(10.1), {0, 0, kPi}, kExact, kExact));
}
}  // namespace psmks
