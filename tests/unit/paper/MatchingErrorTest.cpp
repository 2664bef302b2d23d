/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/MatchingError.h>
#include <psmks/paper/PoseObjective.h>
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
  }

  void associate(int wall, int rays, double residual_m)
  {
    for (int i = 0; i < rays; ++i) associations_.pairs.push_back({0, wall, wall, residual_m, 1});
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

TEST_F(MatchingErrorTest, NoSegmentIsMoreCertainThanItsScanner)
{
  scan_.segments[1].sigma_m = 0.002;
  scan_.rangeNoise = {0.01};
  reliability_.assign(scan_, scan_);
  EXPECT_DOUBLE_EQ(reliability_.ofPair(1, 1).weight(), 20 / 2e-4);
}

TEST_F(MatchingErrorTest, RootMeanSquareIsInMetresAndWeighsByPoints)
{
  associate(0, 10, 0.01);
  EXPECT_NEAR(rmsResidual_m(associations_, reliability_), 0.01, 1e-12);
  associate(1, 60, -0.03);  // 60 rays of 20 points against 10 rays of 120: as much
  EXPECT_NEAR(rmsResidual_m(associations_, reliability_), std::sqrt((1e-4 + 9e-4) / 2), 1e-12);
}

TEST_F(MatchingErrorTest, NothingToCompareIsTheWorstThereIs)
{
  scan_.rangeNoise = {0.01};
  reliability_.assign(scan_, scan_);
  const double nothing = error();
  associate(0, 40, 1.0);
  EXPECT_DOUBLE_EQ(nothing, error());
}

TEST_F(MatchingErrorTest, NothingToCompareHasNoResidual)
{
  EXPECT_EQ(rmsResidual_m(associations_, reliability_), 0);
}

TEST(PoseObjectiveTest, ErrorsCompareOnlyBetweenAboutAsManyRays)
{
  SegmentedScan scan;
  PaperOptions options;
  options.minAssociationShare = 0.9;
  PoseObjective objective;
  objective.assign(scan, scan, options);
  using Value = PoseObjective::Value;
  EXPECT_TRUE(objective.isBetter(Value{1, 95, 0}, Value{2, 100, 0}));
  EXPECT_FALSE(objective.isBetter(Value{2, 100, 0}, Value{1, 95, 0}));
  EXPECT_FALSE(objective.isBetter(Value{1, 80, 0}, Value{2, 100, 0}));  // lost its bad pairs
  EXPECT_TRUE(objective.isBetter(Value{2, 100, 0}, Value{1, 80, 0}));
  EXPECT_FALSE(objective.isBetter(Value{0, options.minAssociations - 1, 0}, Value{2, 30, 0}));
}

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
