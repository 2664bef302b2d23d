/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/MatchingError.h>
#include <psmks/core/PoseObjective.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
Segment segment(int rays, double sigma_m)
{
  Segment s;
  s.rays = rays;
  s.sigma_m = sigma_m;
  return s;
}

/** Two walls in both scans: 0 long and straight, 1 short and rough. */
class MatchingErrorTest : public testing::Test
{
 protected:
  MatchingErrorTest()
  {
    scan_.segments = {segment(60, 0.01), segment(10, 0.02)};
    reliability_.assign(scan_, scan_);
    associations_.tallies.assign(2, {});
  }

  void associate(int wall, int rays, double residual_m)
  {
    for (int i = 0; i < rays; ++i) associations_.pairs.push_back({0, wall, wall, residual_m, 1});
    associations_.tallies[static_cast<std::size_t>(wall)].associated += rays;
  }

  void refuse(int wall, int rays)
  {
    associations_.tallies[static_cast<std::size_t>(wall)].refused += rays;
  }

  double error() const { return matchingError(associations_, reliability_, options_); }

  SegmentedScan scan_;
  SegmentReliability reliability_;
  Associations associations_;
  PaperOptions options_;
};

TEST_F(MatchingErrorTest, WeightGrowsWithPointsAndFallsWithVariance)
{
  const Reliability& good = reliability_.ofPair(0, 0);
  const Reliability& poor = reliability_.ofPair(1, 1);
  EXPECT_DOUBLE_EQ(good.weight(), 120 / 2e-4);
  EXPECT_DOUBLE_EQ(poor.weight(), 20 / 8e-4);
  EXPECT_DOUBLE_EQ(reliability_.ofPair(0, 1).weight(), 70 / 5e-4);
}

TEST_F(MatchingErrorTest, IsTheSquareInStandardDeviations)
{
  associate(0, 40, 0.03);
  EXPECT_NEAR(error(), 0.03 * 0.03 / 2e-4, 1e-12);
}

TEST_F(MatchingErrorTest, DoesNotDependOnTheNumberOfAssociatedRays)
{
  associate(0, 40, 0.03);
  const double fewer = error();
  associate(0, 20, -0.03);
  EXPECT_NEAR(error(), fewer, 1e-12);
}

TEST_F(MatchingErrorTest, LosingABadlyFittingWallDoesNotPay)
{
  associate(0, 40, 0.01);
  associate(1, 10, 0.19);
  const double kept = error();
  associations_.pairs.resize(40);
  associations_.tallies[1] = {0, 10};
  EXPECT_GT(error(), kept);
}

TEST_F(MatchingErrorTest, ARayThatSlipsRoundACornerHardlyCounts)
{
  associate(0, 40, 0.01);
  const double before = error();
  refuse(0, 1);
  const double slipped = error();
  EXPECT_GT(slipped, before);
  // As a full refused ray it would add 1/41 of (20 cm)^2 / s^2 = 4.9.
  EXPECT_LT(slipped - before, 0.2);
}

TEST_F(MatchingErrorTest, NothingToCompareIsNoError) { EXPECT_EQ(error(), 0); }

// The curve of Fig. 1(c): over the orientation the error looks like a U, not a V. Squared errors
// grow fourfold when the offset doubles; absolute ones would double.
TEST(MatchingErrorCurveTest, IsQuadraticAboutItsMinimum)
{
  const std::vector<Wall> walls = officeRoom();
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 720);
  const Pose2 T{0.2, -0.1, 0.3};
  const SegmentedScan reference = segmentByWalls(castScan(walls, {}, grid), walls, {});
  const SegmentedScan current = segmentByWalls(castScan(walls, T, grid), walls, T);
  PoseObjective objective;
  const PaperOptions options;
  objective.assign(reference, current, options);
  const auto errorAt = [&](double offset_deg)
  {
    const double phi_rad = T.phi_rad + degToRad(offset_deg);
    return objective.evaluate({T.x_m, T.y_m, phi_rad}, phi_rad).error;
  };

  const double atMinimum = errorAt(0);
  EXPECT_LT(atMinimum, errorAt(0.1));
  EXPECT_LT(atMinimum, errorAt(-0.1));
  for (const double side : {-1.0, 1.0})
    EXPECT_NEAR((errorAt(0.4 * side) - atMinimum) / (errorAt(0.2 * side) - atMinimum), 4, 0.6);
}
}  // namespace
}  // namespace psmks
