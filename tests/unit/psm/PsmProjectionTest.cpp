/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/psm/PsmProjection.h>
#include <tests/unit/psm/PsmScenes.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
using test::drawnScan;
using test::kNothing_m;
using test::prepared;
using test::preparedScene;

class PsmProjectionTest : public testing::Test
{
 protected:
  /** Projects a scan to a reference that is at the origin of the world. */
  void project(const std::vector<Wall>& walls, const Pose2& T_world_current)
  {
    current_ = preparedScene(walls, T_world_current, currentGrid_);
    projectPsmScan(current_, T_world_current, referenceGrid_, projection_);
  }

  std::size_t rayAt(double bearing_deg) const
  {
    return static_cast<std::size_t>(std::lround(referenceGrid_.index(degToRad(bearing_deg))));
  }

  double range_m(double bearing_deg) const { return projection_.range_m[rayAt(bearing_deg)]; }
  PsmTag tag(double bearing_deg) const { return projection_.tag[rayAt(bearing_deg)]; }

  BeamGrid referenceGrid_ = BeamGrid::centered(kPi, 361);
  BeamGrid currentGrid_ = BeamGrid::centered(kPi, 361);
  PsmScan current_;
  PsmProjection projection_;
};

TEST_F(PsmProjectionTest, FromItsOwnViewpointAScanIsItself)
{
  project(officeRoom(), {});
  for (std::size_t i = 0; i < 361; ++i)
  {
    if (current_.segment[i] == PsmScan::kNoSurface) continue;
    EXPECT_EQ(projection_.tag[i], PsmTag::Good) << i;
    EXPECT_NEAR(projection_.range_m[i], current_.range_m[i], 1e-6) << i;
  }
}

/** The smallest range to a surface at a bearing, found by testing every pair of points. */
double bruteForce_m(const PsmScan& current, const Pose2& T_ref_cur, double bearing_rad)
{
  double nearest_m = kNothing_m;
  for (int i = 1; i < current.rays(); ++i)
  {
    if (!current.sameSurface(i - 1, i)) continue;
    const Eigen::Vector2d a = T_ref_cur * current.point(i - 1), b = T_ref_cur * current.point(i);
    const double toA_rad = wrapAngle(std::atan2(a.y(), a.x()) - bearing_rad);
    const double toB_rad = wrapAngle(std::atan2(b.y(), b.x()) - bearing_rad);
    const bool between = toA_rad * toB_rad <= 0 && std::abs(toA_rad - toB_rad) < kPi;
    if (!between) continue;
    const double share = toA_rad / (toA_rad - toB_rad);
    nearest_m = std::min(nearest_m, (1 - share) * a.norm() + share * b.norm());
  }
  return nearest_m;
}

TEST_F(PsmProjectionTest, EveryRayShowsTheNearestOfAllSurfacesOnIt)
{
  const Pose2 T{0.6, -0.45, degToRad(13)};
  project(clutteredRoom(3), T);
  int drawn = 0;
  for (int i = 0; i < referenceGrid_.count(); ++i)
  {
    const auto p = static_cast<std::size_t>(i);
    const double expected_m = bruteForce_m(current_, T, referenceGrid_.bearing_rad(i));
    if (std::isinf(expected_m))
      EXPECT_EQ(projection_.tag[p], PsmTag::Empty) << i;
    else
      EXPECT_NEAR(projection_.range_m[p], expected_m, 1e-6) << i;
    drawn += projection_.tag[p] != PsmTag::Empty;
  }
  EXPECT_GT(drawn, 250);
}

// The current scan c passes from a post's face to the wall behind it, which r cannot see there.
//
//    -------------------- x = 4
//              .
//        ---- post, x = 2
//
//         r       c
TEST_F(PsmProjectionTest, ANearSurfaceHidesWhatIsBehindIt)
{
  project({{{4, -9}, {4, 9}}, {{2, -0.5}, {2, 0.5}}}, {0, -1.5, 0});
  EXPECT_NEAR(range_m(0), 2, 1e-3);
  EXPECT_EQ(tag(0), PsmTag::Good);
  EXPECT_NEAR(range_m(-30), 4 / std::cos(degToRad(30)), 1e-3);
}

// c looks all around and sees the back of a board that stands between it and r.
//
//    -------------------- x = 6
//         c               x = 4
//        ----             board, x = 2
//
//         r
TEST_F(PsmProjectionTest, ASurfaceSeenFromBehindIsOccludedButStillHides)
{
  currentGrid_ = BeamGrid::centered(2 * kPi, 720);
  project({{{6, -9}, {6, 9}}, {{2, -0.5}, {2, 0.5}}}, {4, 0, 0});
  EXPECT_EQ(tag(0), PsmTag::Occluded);
  EXPECT_NEAR(range_m(0), 2, 1e-3);
  EXPECT_EQ(tag(25), PsmTag::Good);
  EXPECT_NEAR(range_m(25), 6 / std::cos(degToRad(25)), 1e-2);
}

TEST_F(PsmProjectionTest, NothingIsDrawnBetweenSurfacesNorForLonePoints)
{
  const PsmScan scan = prepared(drawnScan({2, 2, 2, 3.5, 5, 5, 5}));
  projectPsmScan(scan, {}, scan.grid, projection_);
  EXPECT_EQ(projection_.tag[3], PsmTag::Empty);
  EXPECT_TRUE(std::isinf(projection_.range_m[3]));
  EXPECT_EQ(std::count(projection_.tag.begin(), projection_.tag.end(), PsmTag::Good), 6);
}

TEST_F(PsmProjectionTest, ARoomAllAroundHasNoGapAtTheSeam)
{
  currentGrid_ = referenceGrid_ = BeamGrid::centered(2 * kPi, 360);
  project(squareRoom(), {0.3, -0.2, degToRad(77)});
  EXPECT_EQ(std::count(projection_.tag.begin(), projection_.tag.end(), PsmTag::Good), 360);
  EXPECT_NEAR(range_m(-180), 3, 1e-3);
}
}  // namespace
}  // namespace psmks
