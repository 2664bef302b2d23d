/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/ShortLines.h>

namespace psmks
{
namespace
{
//         o----o----o        a wall 8 m ahead, one degree a ray: 14 cm from ray to ray
//          \   |   /
//    ####   \  |  /   ####   two nearer things hide the rest of it
//              ^ scanner
const Line kFarWall{8, 0, Eigen::Matrix2d::Zero()};
constexpr int kAhead = 90;

class ShortLinesTest : public testing::Test
{
 protected:
  /** 181 rays over 180 degrees, none of which returns. */
  ShortLinesTest()
  {
    scan_.grid = BeamGrid::centered(kPi, 181);
    scan_.range_m.assign(181, 0.0);
    scan_.valid.assign(181, 0);
    scan_.segmentOfRay.assign(181, SegmentedScan::kNoSegment);
    scan_.rangeNoise = {0.01};
  }

  void setRay(int ray, double range_m)
  {
    scan_.range_m[static_cast<std::size_t>(ray)] = range_m;
    scan_.valid[static_cast<std::size_t>(ray)] = 1;
  }

  /** Rays on a line, the last one included. */
  void see(const Line& line, int first, int last)
  {
    for (int ray = first; ray <= last; ++ray)
      setRay(ray, line.rangeAt_m(scan_.grid.bearing_rad(ray)));
  }

  void move(int ray, double by_m) { scan_.range_m[static_cast<std::size_t>(ray)] += by_m; }

  std::vector<Segment> found() const
  {
    std::vector<Segment> lines(1);  // what was there goes
    findShortLines(scan_, circleOfRay_, lines);
    return lines;
  }

  SegmentedScan scan_;
  std::vector<int> circleOfRay_ = std::vector<int>(181, -1);
};
}  // namespace

TEST_F(ShortLinesTest, ThreeRaysOnAFarWallAreALine)
{
  see(kFarWall, kAhead - 1, kAhead + 1);
  const auto lines = found();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].line.r0_m, 8, 1e-9);
  EXPECT_NEAR(lines[0].line.phi0_rad, 0, 1e-9);
  EXPECT_EQ(lines[0].firstRay, kAhead - 1);
  EXPECT_EQ(lines[0].lastRay, kAhead + 1);
  EXPECT_EQ(lines[0].rays, 3);
  EXPECT_NEAR(lines[0].length_m(), 2 * 8 * std::tan(degToRad(1)), 1e-9);
}

// Its direction is known by the angle that a centimetre of noise makes at its ends: 2.9 degrees.
TEST_F(ShortLinesTest, TheirUncertaintyIsThatOfTheirFewRays)
{
  see(kFarWall, kAhead - 1, kAhead + 1);
  const double end_m = 8 * std::tan(degToRad(1));
  const double expected_rad = 0.01 / (std::sqrt(2.0) * end_m);
  EXPECT_NEAR(std::sqrt(found().at(0).line.covariance(1, 1)), expected_rad, 0.01 * expected_rad);
}

TEST_F(ShortLinesTest, TwoRaysAreNone)
{
  see(kFarWall, kAhead, kAhead + 1);
  EXPECT_TRUE(found().empty());
}

TEST_F(ShortLinesTest, RaysThatBendByMoreThanTheNoiseAreNone)
{
  see(kFarWall, kAhead - 1, kAhead + 1);
  move(kAhead, 0.01);
  EXPECT_EQ(found().size(), 1U);
  move(kAhead, 0.09);
  EXPECT_TRUE(found().empty());
  scan_.rangeNoise = {0.1};
  EXPECT_EQ(found().size(), 1U);
}

// A leg of a chair 2 m ahead: its 7 cm may be round.
TEST_F(ShortLinesTest, WhatIsAsThinAsALegIsNone)
{
  see({2, 0, Eigen::Matrix2d::Zero()}, kAhead - 1, kAhead + 1);
  EXPECT_TRUE(found().empty());
}

//        o--o--o--o            two walls, one 2 m before the other
//                   o--o--o--o
TEST_F(ShortLinesTest, AStepSeparates)
{
  see(kFarWall, 86, 89);
  see({6, 0, Eigen::Matrix2d::Zero()}, 90, 93);
  const auto lines = found();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].line.r0_m, 8, 1e-6);
  EXPECT_EQ(lines[0].lastRay, 89);
  EXPECT_NEAR(lines[1].line.r0_m, 6, 1e-6);
  EXPECT_EQ(lines[1].firstRay, 90);
}

TEST_F(ShortLinesTest, ARayWithoutReturnSeparates)
{
  see(kFarWall, 86, 92);
  scan_.valid[89] = 0;
  ASSERT_EQ(found().size(), 2U);
  EXPECT_EQ(found()[0].lastRay, 88);
  EXPECT_EQ(found()[1].firstRay, 90);
}

TEST_F(ShortLinesTest, RaysOfSegmentsAreLeftAlone)
{
  see(kFarWall, 86, 92);
  scan_.segments.resize(1);
  scan_.segments[0].firstRay = 86;
  scan_.segments[0].lastRay = 89;
  for (std::size_t ray = 86; ray <= 89; ++ray) scan_.segmentOfRay[ray] = 0;
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(found()[0].firstRay, 90);
}

TEST_F(ShortLinesTest, RaysOfCirclesAreLeftAlone)
{
  see(kFarWall, 86, 92);
  for (std::size_t ray = 86; ray <= 89; ++ray) circleOfRay_[ray] = 0;
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(found()[0].firstRay, 90);
}

//   -----------------o--o--o-----   a wall half a metre to the left, seen along
//   ^ scanner
TEST_F(ShortLinesTest, GrazingRaysAreNone)
{
  const Line beside{0.5, kPi / 2, Eigen::Matrix2d::Zero()};
  see(beside, kAhead + 8, kAhead + 10);
  EXPECT_TRUE(found().empty());
  see(beside, kAhead + 13, kAhead + 15);
  EXPECT_EQ(found().size(), 1U);
}
}  // namespace psmks
