/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/SegmentationQuality.h>

namespace psmks
{
namespace
{
constexpr int kNone = SegmentedScan::kNoSegment;

Segment segment(double r0_m, double phi0_rad)
{
  Segment s;
  s.line = {r0_m, phi0_rad, Eigen::Vector2d(1e-4, 4e-4).asDiagonal()};
  return s;
}

// ray         0   1   2   3   4   5   6   7   8   9
// wall        A   A   A   A   B   B   B   B   -   B
// segment     0   0   0   0   0   1   1   1   .   .     . = none; ray 8 has no return
SegmentedScan tenRays()
{
  SegmentedScan scan;
  scan.grid = BeamGrid(0, 0.1, 10);
  scan.range_m.assign(10, 2.0);
  scan.valid.assign(10, 1);
  scan.valid[8] = 0;
  scan.segmentOfRay = {0, 0, 0, 0, 0, 1, 1, 1, kNone, kNone};
  scan.segments = {segment(2.01, 0), segment(3, 1.04)};
  return scan;
}

const WallTruth kTruth{{0, 0, 0, 0, 1, 1, 1, 1, WallTruth::kNoWall, 1},
                       {{2, 0, Eigen::Matrix2d::Zero()}, {3, 1, Eigen::Matrix2d::Zero()}}};

SegmentationQuality qualityOfTenRays()
{
  SegmentationQuality quality;
  quality.add(tenRays(), kTruth);
  return quality;
}
}  // namespace

TEST(SegmentationQuality, CountsRays)
{
  const SegmentationQuality quality = qualityOfTenRays();
  EXPECT_DOUBLE_EQ(quality.usedShare(), 8.0 / 9);
  EXPECT_DOUBLE_EQ(quality.rightWallShare(), 7.0 / 8);
  EXPECT_DOUBLE_EQ(quality.segmentsPerScan(), 2);
  EXPECT_DOUBLE_EQ(quality.raysPerSegment(), 4);
}

// Segment 0 is 1 cm off (one sigma), segment 1 is 0.04 rad off (two sigmas).
TEST(SegmentationQuality, NormalisesErrorsByTheCovariance)
{
  EXPECT_NEAR(qualityOfTenRays().neesMean(), (1 + 4) / 2.0, 1e-9);
  EXPECT_DOUBLE_EQ(qualityOfTenRays().ellipseShare(), 1);
}

TEST(SegmentationQuality, ErrorsAreMedians)
{
  EXPECT_NEAR(qualityOfTenRays().offsetMedian_m(), 0.005, 1e-12);
  EXPECT_NEAR(qualityOfTenRays().angleMedian_rad(), 0.02, 1e-12);
}

// A wall through the sensor: 1 mm on one side of it or 1 mm on the other is an error of 2 mm.
TEST(SegmentationQuality, BothFormsOfALineNearTheOriginAreNeighbours)
{
  SegmentedScan scan = tenRays();
  scan.segments[0] = scan.segments[1] = segment(0.001, 0.5);
  WallTruth truth = kTruth;
  truth.lines[0] = truth.lines[1] = {0.001, 0.5 - kPi, Eigen::Matrix2d::Zero()};
  SegmentationQuality quality;
  quality.add(scan, truth);
  EXPECT_NEAR(quality.offsetMedian_m(), 0.002, 1e-12);
  EXPECT_NEAR(quality.angleMedian_rad(), 0, 1e-12);
}
}  // namespace psmks
