/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/ScanScores.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** The scan of some walls from the origin. */
SegmentedScan scanOf(const std::vector<Wall>& walls, const BeamGrid& grid)
{
  return segmentByWalls(castScan(walls, {}, grid), walls, {});
}

/** Rays from -halfField to +halfField. */
BeamGrid raysWithin(double halfField_deg, double step_deg)
{
  const int count = static_cast<int>(std::lround(2 * halfField_deg / step_deg)) + 1;
  return BeamGrid::centered(degToRad(2 * halfField_deg), count);
}

//  bearing       x = 1.5   2   3      Two scans from one place. The reference sees one wall at
//   20.5 to  40            :   c      x = 2 m, by 80 rays at -39.5, -38.5, ..., 39.5 degrees. The
//  -20.5 to  20.5    c     :          current scan sees three pieces of wall, by 81 rays at -40,
//  -40   to -20.5          c          -39, ..., 40 degrees. The middle one is 1.1 m wide: too wide
//                          r          for an object that may have been moved.
class CountedScanScores : public testing::Test
{
 protected:
  static std::vector<Wall> threePieces()
  {
    const auto at = [](double x_m, double bearing_deg)
    { return Eigen::Vector2d(x_m, x_m * std::tan(degToRad(bearing_deg))); };
    return {{at(2, -41), at(2, -20.5)}, {at(1.5, -20.5), at(1.5, 20.5)}, {at(3, 20.5), at(3, 41)}};
  }

  static std::vector<Wall> oneWall() { return {{{2, -5}, {2, 5}}}; }

  /** The looks of rays 1 degree apart that end at x, of those between two bearings every so many.
   */
  static double looks(double x_m, double first_deg, double last_deg, double every_deg)
  {
    double sum = 0;
    for (double deg = first_deg; deg < last_deg + every_deg / 2; deg += every_deg)
      sum += std::min(1.0, x_m / std::cos(degToRad(deg)) * degToRad(1) / RayPoints::kLook_m);
    return sum;
  }

  JointScene scene_{scanOf(oneWall(), raysWithin(39.5, 1)),
                    scanOf(threePieces(), raysWithin(40, 1))};
};
}  // namespace

// Current rays against the wall at 2 m: 19 on it (-39 to -21 degrees), 41 in front (-20 to 20), 19
// behind (21 to 39) and two outside the reference's view. Reference rays against the three pieces:
// 20 on the first (-39.5 to -20.5, the last one at its edge), 40 behind the second, 19 before the
// third; the one at 20.5 degrees lies between both sides of a jump and tells nothing.
TEST_F(CountedScanScores, AllRaysOfBothScansAreCountedByTheirLooks)
{
  const RayCounts n = scene_.scores().allCounts({});
  constexpr double kRounding = 1e-4;  // of sums of 40 single-precision numbers
  EXPECT_NEAR(n.on, looks(2, -39, -21, 1) + looks(2, -39.5, -20.5, 1), kRounding);
  EXPECT_NEAR(n.front, looks(1.5, -20, 20, 1) + looks(2, 21.5, 39.5, 1), kRounding);
  EXPECT_NEAR(n.behind, looks(3, 21, 39, 1) + looks(2, -19.5, 19.5, 1), kRounding);
  EXPECT_NEAR(n.unknown, looks(2, -40, -40, 1) + looks(3, 40, 40, 1), kRounding);
  EXPECT_EQ(n.moved + n.uncovered, 0);
  EXPECT_EQ(n.raysOn, 19 + 20);
  EXPECT_EQ(n.rays, 81 + 80);
}

// 39 of the 161 rays are on a surface: of a scan, which has 80.5 rays on average, 19.5.
TEST_F(CountedScanScores, InlierRaysAreTheMeanOfBothScans)
{
  const ScanScores scores = scene_.scores();
  EXPECT_NEAR(scores.inlierRays(scores.allCounts({})), 80.5 * 39 / 161, 1e-12);
}

TEST_F(CountedScanScores, WithoutACountedRayNoneIsAnInlier)
{
  EXPECT_EQ(scene_.scores().inlierRays({}), 0);
}

// Every fourth current ray: at -36, -32, -28 and -24 degrees on the wall, the 11 from -20 to 20 in
// front of it, which count four times, 4 behind. No reference ray counts.
TEST_F(CountedScanScores, ARoughScoreIsOfEveryFourthCurrentRay)
{
  const double on = looks(2, -36, -24, 4), front = looks(1.5, -20, 20, 4);
  const double behind = looks(3, 24, 36, 4);
  EXPECT_NEAR(scene_.scores().roughScore({}), on / (on + 4 * front + behind), 1e-5);
}

// Ten times as many rays: some of them are enough for the shares, and the number of inliers is
// still that of all rays, the looks are those of all surfaces. The pieces have four edges, at each
// of which a stride may take or leave one ray more than its share; a ray that is taken stands for
// at most 810 / 180 = 4.5 others.
TEST_F(CountedScanScores, OfManyRaysAShareIsEnough)
{
  JointScene dense(scanOf(oneWall(), raysWithin(39.5, 0.1)),
                   scanOf(threePieces(), raysWithin(40, 0.1)));
  const ScanScores scores = dense.scores();
  const RayCounts n = scores.allCounts({});
  const int rays = 791 + 801;
  EXPECT_LT(n.rays, rays / 2);
  EXPECT_GE(n.rays, 2 * 180 - 2);
  const double ofAll = 0.5 * (791.0 * 20 / 79 + 801.0 * 20 / 80.0);
  EXPECT_NEAR(scores.inlierRays(n), ofAll, 4 * 4.5);
  const RayCounts coarse = scene_.scores().allCounts({});
  const double edges = 4 * 4.5 * 3 / std::cos(degToRad(40)) * degToRad(0.1) / RayPoints::kLook_m;
  EXPECT_NEAR(n.on, coarse.on, edges);
  EXPECT_NEAR(n.front, coarse.front, edges);
  EXPECT_NEAR(n.behind, coarse.behind, edges);
}

//  +-------+
//  |  r c  |   one room, two places: every ray of either scan ends on a wall that the other sees
//  +-------+
TEST(ScanScoresOfARoom, AtTheTruePoseEveryRayIsOnASurface)
{
  const Pose2 truth{0.4, -0.3, 0.25};
  JointScene scene(squareRoom(), truth, BeamGrid::centered(2 * kPi, 360));
  const RayCounts n = scene.scores().allCounts(truth);
  EXPECT_EQ(n.raysOn, n.rays);
  EXPECT_EQ(freeSpaceScore(n), 1);
  EXPECT_LT(scene.scores().allCounts(truth.inverse()).on, n.on / 2) << "the other way round";
}

//  o    |      a wall at x = 2 m. A pose that is wrong by 10 cm moves all current rays before or
//  o    |      behind it.
class ScanScoresOfAWall : public testing::Test
{
 protected:
  JointScene scene_{{{{2, -5}, {2, 5}}}, {}, raysWithin(40, 1)};
  const Pose2 nearer_{-0.1, 0, 0}, farther_{0.1, 0, 0};
};

// The ranges have a sigma of 1 cm: 10 cm are ten times that, and no chance.
TEST_F(ScanScoresOfAWall, NoRayIsOnASurfaceTenCentimetresOff)
{
  EXPECT_EQ(scene_.scores().allCounts(nearer_).on, 0);
  EXPECT_EQ(scene_.scores().allCounts(farther_).on, 0);
  EXPECT_EQ(freeSpaceScore(scene_.scores().allCounts({})), 1);
}

TEST_F(ScanScoresOfAWall, RoughlyAStartTenCentimetresOffIsAsGoodAsTheTruth)
{
  EXPECT_EQ(scene_.scores().roughScore(nearer_), 1);
  EXPECT_EQ(scene_.scores().roughScore(farther_), 1);
  EXPECT_EQ(scene_.scores().roughScore({0.5, 0, 0}), 0);
}

// Three sigma is what a wall's rays keep from it: 10 cm are within reach of a sigma of 5 cm.
TEST_F(ScanScoresOfAWall, RaysOfANoisyScannerMayBeFartherFromTheWall)
{
  const ScanScores noisy(scene_.buffers.reference, scene_.buffers.current, 0.05);
  EXPECT_EQ(freeSpaceScore(noisy.allCounts(nearer_)), 1);
}
}  // namespace psmks
