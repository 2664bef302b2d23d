/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/OrientationSearch.h>
#include <tests/support/Scenes.h>

#include <algorithm>

namespace psmks
{
namespace
{
class OrientationSearchTest : public testing::Test
{
 protected:
  /** The sensor turns by `turn_deg` on the spot; the search starts from no turn. */
  OrientationMinimum search(double turn_deg, MatchTrace* trace = nullptr)
  {
    const std::vector<Wall> walls = officeRoom();
    const Pose2 T{0, 0, degToRad(turn_deg)};
    std::mt19937 rng(1);
    reference_ = segmentByWalls(castScan(walls, {}, grid_, 30, 0.01, rng), walls, {});
    current_ = segmentByWalls(castScan(walls, T, grid_, 30, 0.01, rng), walls, T);
    objective_.assign(reference_, current_, options_);
    return searchOrientation(objective_, {}, trace);
  }

  BeamGrid grid_ = BeamGrid::centered(kPi, 361);
  SegmentedScan reference_, current_;
  PaperOptions options_;
  PoseObjective objective_;
};

TEST_F(OrientationSearchTest, FindsATurnWithinItsStep)
{
  for (const double turn_deg : {7.3, -7.3, 0.0, 18.26, -12.94})
  {
    const OrientationMinimum minimum = search(turn_deg);
    ASSERT_TRUE(minimum.found) << turn_deg;
    EXPECT_NEAR(radToDeg(minimum.phi_rad), turn_deg, 0.1);
  }
}

TEST_F(OrientationSearchTest, GateAtThePriorOrientationLimitsTheReach)
{
  options_.gateOrientation = GateOrientation::Prior;
  EXPECT_NEAR(radToDeg(search(4.2).phi_rad), 4.2, 0.1);
  EXPECT_GT(std::abs(radToDeg(search(7.3).phi_rad) - 7.3), 0.5);
}

TEST_F(OrientationSearchTest, TraceHoldsBothCurves)
{
  MatchTrace trace;
  const OrientationMinimum minimum = search(7.3, &trace);
  ASSERT_EQ(trace.orientationCurves.size(), 2U);
  const MatchTrace::OrientationCurve& coarse = trace.orientationCurves[0];
  const MatchTrace::OrientationCurve& fine = trace.orientationCurves[1];
  EXPECT_EQ(coarse.phi_rad.size(), 41U);
  EXPECT_EQ(fine.phi_rad.size(), 21U);
  EXPECT_NEAR(radToDeg(coarse.phi_rad.front()), -20, 1e-9);
  EXPECT_NEAR(radToDeg(coarse.phi_rad.back()), 20, 1e-9);
  EXPECT_EQ(*std::min_element(fine.error.begin(), fine.error.end()), minimum.value.error);
}

TEST_F(OrientationSearchTest, OrientationsThatLoseRaysDoNotCount)
{
  MatchTrace trace;
  const OrientationMinimum minimum = search(7.3, &trace);
  for (const MatchTrace::OrientationCurve& curve : trace.orientationCurves)
  {
    const int most = *std::max_element(curve.associations.begin(), curve.associations.end());
    EXPECT_GE(minimum.value.associations, options_.minAssociationShare * most);
  }
}

TEST_F(OrientationSearchTest, StepsAndRangesAreOptions)
{
  options_.coarseRange_rad = degToRad(5);
  options_.coarseStep_rad = degToRad(0.5);
  options_.fineRange_rad = 0;
  MatchTrace trace;
  search(3, &trace);
  EXPECT_EQ(trace.orientationCurves[0].phi_rad.size(), 21U);
  EXPECT_EQ(trace.orientationCurves[1].phi_rad.size(), 1U);
}

TEST_F(OrientationSearchTest, TooFewRaysFindNothingAndKeepTheStart)
{
  options_.minAssociations = 362;
  const OrientationMinimum minimum = search(2);
  EXPECT_FALSE(minimum.found);
  EXPECT_EQ(minimum.phi_rad, 0);
}
}  // namespace
}  // namespace psmks
