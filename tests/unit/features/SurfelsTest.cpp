/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/Surfels.h>

namespace psmks
{
namespace
{
/** A scan of one degree a ray over 180 degrees without segments: 0 = no return. */
SegmentedScan unsegmented()
{
  SegmentedScan scan;
  scan.grid = BeamGrid::centered(kPi, 181);
  scan.range_m.assign(181, 0.0);
  scan.valid.assign(181, 0);
  scan.segmentOfRay.assign(181, SegmentedScan::kNoSegment);
  scan.rangeNoise = {0.01};
  return scan;
}

void setRay(SegmentedScan& scan, int ray, double range_m)
{
  scan.range_m[static_cast<std::size_t>(ray)] = range_m;
  scan.valid[static_cast<std::size_t>(ray)] = 1;
}

struct Found
{
  std::vector<AnchoredLine> lines;
  std::vector<int> lineOfRay;
};

Found patchesOf(const SegmentedScan& scan)
{
  Found found;
  found.lineOfRay = scan.segmentOfRay;
  appendSurfels(scan, found.lines, found.lineOfRay);
  return found;
}

//        o o o        four rays on a wall 2 m ahead, 3.5 cm apart: too few for a segment
//          |
//          ^ scanner
TEST(Surfels, AShortWallIsOnePatch)
{
  SegmentedScan scan = unsegmented();
  const Line wall{2.0, 0, Eigen::Matrix2d::Zero()};
  for (int ray = 89; ray <= 92; ++ray)
    setRay(scan, ray, wall.rangeAt_m(scan.grid.bearing_rad(ray)));
  const Found found = patchesOf(scan);
  ASSERT_EQ(found.lines.size(), 1u);
  EXPECT_NEAR(found.lines[0].distance_m, 2.0, 1e-6);
  EXPECT_NEAR(found.lines[0].normal.y(), 0, 1e-6);
  EXPECT_GE(found.lines[0].distanceVariance_m2, 0.01 * 0.01);  // of the unknown shape
  EXPECT_EQ(found.lineOfRay[89], 0);
  EXPECT_EQ(found.lineOfRay[92], 0);
  EXPECT_EQ(found.lineOfRay[93], -1);
}

TEST(Surfels, ALongerRunIsCutIntoPieces)
{
  SegmentedScan scan = unsegmented();
  for (int ray = 80; ray <= 100; ++ray) setRay(scan, ray, 2.0);  // an arc of 70 cm
  EXPECT_EQ(patchesOf(scan).lines.size(), 3u);
}

TEST(Surfels, TwoRaysAreNone)
{
  SegmentedScan scan = unsegmented();
  setRay(scan, 90, 2.0);
  setRay(scan, 91, 2.0);
  EXPECT_TRUE(patchesOf(scan).lines.empty());
}

// Neighbouring rays on two objects, half a metre apart in depth.
TEST(Surfels, AJumpSeparates)
{
  SegmentedScan scan = unsegmented();
  for (int ray = 88; ray <= 90; ++ray) setRay(scan, ray, 2.0);
  for (int ray = 91; ray <= 93; ++ray) setRay(scan, ray, 2.5);
  const Found found = patchesOf(scan);
  ASSERT_EQ(found.lines.size(), 2u);
  EXPECT_NE(found.lineOfRay[90], found.lineOfRay[91]);
}

TEST(Surfels, RaysOfSegmentsAreLeftAlone)
{
  SegmentedScan scan = unsegmented();
  for (int ray = 88; ray <= 92; ++ray)
  {
    setRay(scan, ray, 2.0);
    scan.segmentOfRay[static_cast<std::size_t>(ray)] = 0;
  }
  scan.segments.resize(1);
  EXPECT_TRUE(patchesOf(scan).lines.empty());
}

// Rays that scatter by decimetres, leaves of a plant.
TEST(Surfels, RoughObjectsAreNone)
{
  SegmentedScan scan = unsegmented();
  for (int ray = 86; ray <= 94; ++ray) setRay(scan, ray, ray % 2 ? 2.0 : 2.09);
  EXPECT_TRUE(patchesOf(scan).lines.empty());
}
}  // namespace
}  // namespace psmks
