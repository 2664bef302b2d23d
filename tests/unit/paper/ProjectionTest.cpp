/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/Projection.h>
#include <tests/support/Scenes.h>

#include <algorithm>

namespace psmks
{
namespace
{
constexpr double kMaxRange_m = 30;

/** Tests of a current scan that is projected to the viewpoint of a reference at the origin. */
class ProjectionTest : public testing::Test
{
 protected:
  void project(const std::vector<Wall>& walls, const Pose2& T_world_current, const BeamGrid& grid)
  {
    reference_ = segmentByWalls(castScan(walls, {}, grid, kMaxRange_m), walls, {});
    current_ =
        segmentByWalls(castScan(walls, T_world_current, grid, kMaxRange_m), walls, T_world_current);
    wallOfRay_ = wallsSeen(walls, T_world_current, grid, kMaxRange_m);
    rays_.assign(current_);
    projectScan(rays_, current_, T_world_current, reference_, projection_);
  }

  /** The number of rays of a wall with a mark. */
  int count(int wall, RayMark mark) const
  {
    int n = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i)
      n +=
          wallOfRay_[static_cast<std::size_t>(rays_.ray[i])] == wall && projection_.mark[i] == mark;
    return n;
  }

  int countAll(RayMark mark) const
  {
    return static_cast<int>(std::count(projection_.mark.begin(), projection_.mark.end(), mark));
  }

  SegmentedScan reference_, current_;
  std::vector<int> wallOfRay_;
  DenoisedRays rays_;
  Projection projection_;
};

TEST_F(ProjectionTest, PointsComeWhereTheReferenceMeasuresThem)
{
  const std::vector<Wall> walls = squareRoom();
  project(walls, {0.4, -0.3, 0.5}, BeamGrid::centered(2 * kPi, 360));
  ASSERT_EQ(rays_.size(), 360U);
  for (std::size_t i = 0; i < rays_.size(); ++i)
  {
    const double bearing_rad = std::atan2(projection_.y_m[i], projection_.x_m[i]);
    const BeamGrid oneRay(bearing_rad, 1, 1);
    EXPECT_NEAR(projection_.range_m[i], castScan(walls, {}, oneRay).range_m[0], 1e-6);
    EXPECT_NEAR(projection_.index[i], reference_.grid.index(bearing_rad), 1e-3);
    EXPECT_EQ(projection_.mark[i], RayMark::Visible);
  }
}

// Fig. 1(a): the current scan c passes from a post's face, 1, to the wall behind it, 2. From the
// reference r the points 2 lie at smaller bearings than the last of 1: the bearing runs backwards,
// and the face covers them.
//
//    ---------222------------- wall 0
//            .   |
//          .      |
//        111 post  |
//         |         |
//         r          c
TEST_F(ProjectionTest, PointsBehindANearerSurfaceAreHidden)
{
  const std::vector<Wall> walls = {{{4, -6}, {4, 6}}, {{2, 0.5}, {2, -0.5}}};
  project(walls, {0, -1.5, 0}, BeamGrid::centered(kPi, 361));

  // Behind the post, seen from r: |y| < 1 on the far wall. From c it covers y in (0.5, 2.5).
  int expectedHidden = 0;
  for (std::size_t i = 0; i < rays_.size(); ++i)
  {
    if (wallOfRay_[static_cast<std::size_t>(rays_.ray[i])] != 0) continue;
    const double y = projection_.y_m[i];
    if (std::abs(std::abs(y) - 1) < 0.05) continue;
    EXPECT_EQ(projection_.mark[i] == RayMark::Hidden, std::abs(y) < 1) << "y " << y;
    expectedHidden += std::abs(y) < 1;
  }
  EXPECT_GT(expectedHidden, 5);
  EXPECT_EQ(count(1, RayMark::Hidden), 0);
  EXPECT_GT(count(1, RayMark::Visible), 10);
}

// Fig. 1(b): the first points of the current scan c lie on a wall that shows r its other side.
// There is no point before them that their bearings could fall behind.
//
//            1 |
//      c ->  2 |    r              | wall 1
//            3 |
TEST_F(ProjectionTest, WallSeenFromItsOtherSideIsKnownWithoutPreviousPoints)
{
  const std::vector<Wall> walls = {{{-2, -0.4}, {-2, 0.4}}, {{6, -4}, {6, 4}}};
  // c looks at wall 0 from the left (x = -4); r at the origin sees it from the right.
  project(walls, {-4, 0, 0}, BeamGrid::centered(2 * kPi, 720));
  EXPECT_GT(count(0, RayMark::SeenFromBehind), 40);
  EXPECT_EQ(count(0, RayMark::Visible), 0);
  EXPECT_GT(count(1, RayMark::Visible), 10);
}

// A surface that turns its back still hides what is behind it.
//
//          |              |
//     r    |    c         | wall 1
//          | wall 0       |
TEST_F(ProjectionTest, SurfaceSeenFromBehindHides)
{
  const std::vector<Wall> walls = {{{2, -2}, {2, 2}}, {{5, -1.5}, {5, 1.5}}};
  project(walls, {3, 0, 0}, BeamGrid::centered(2 * kPi, 720));
  EXPECT_GT(count(0, RayMark::SeenFromBehind), 50);
  EXPECT_GT(count(1, RayMark::Hidden), 50);
  EXPECT_EQ(count(1, RayMark::Visible), 0);
}

TEST_F(ProjectionTest, SinglePointsThatRunBackwardsAreSeenFromBehind)
{
  const std::vector<Wall> walls = {{{2, -1}, {2, 1}}};
  const Pose2 T_world_current{4, 0, kPi};
  const BeamGrid grid = BeamGrid::centered(kPi, 181);
  current_ = segmentByWalls(castScan(walls, T_world_current, grid), walls, T_world_current);
  current_.segments.clear();
  std::fill(current_.segmentOfRay.begin(), current_.segmentOfRay.end(), SegmentedScan::kNoSegment);
  reference_ = segmentByWalls(castScan(walls, {}, grid), walls, {});
  rays_.assign(current_);
  projectScan(rays_, current_, T_world_current, reference_, projection_);
  ASSERT_GT(rays_.size(), 20U);
  EXPECT_EQ(countAll(RayMark::SeenFromBehind), static_cast<int>(rays_.size()) - 1);
}

class ProjectionFieldOfViewTest : public ProjectionTest, public testing::WithParamInterface<double>
{
};

// The sensor turns on the spot: every ray that was in the field of view before is visible, every
// other is outside.
TEST_P(ProjectionFieldOfViewTest, RaysOutsideAreMarked)
{
  const double fieldOfView_rad = degToRad(GetParam()), turn_rad = degToRad(20);
  const BeamGrid grid = BeamGrid::centered(fieldOfView_rad, 361);
  project(squareRoom(), {0, 0, turn_rad}, grid);
  for (std::size_t i = 0; i < rays_.size(); ++i)
  {
    const double beyond_rad =
        std::abs(wrapAngle(grid.bearing_rad(rays_.ray[i]) + turn_rad)) - fieldOfView_rad / 2;
    if (std::abs(beyond_rad) < grid.increment_rad()) continue;
    EXPECT_EQ(projection_.mark[i] == RayMark::OutsideView, beyond_rad > 0)
        << "ray " << rays_.ray[i];
  }
}
INSTANTIATE_TEST_SUITE_P(Degrees, ProjectionFieldOfViewTest,
                         testing::Values(60.0, 100.0, 180.0, 270.0, 340.0));

// On a closed scan the seam (behind the sensor) is no edge, wherever the turn puts it.
TEST_F(ProjectionTest, SeamOfAClosedScanIsNoEdge)
{
  for (const double turn_deg : {0.0, 0.3, 45.0, 179.9, -135.0})
  {
    project(squareRoom(), {0.1, 0.05, degToRad(turn_deg)}, BeamGrid::centered(2 * kPi, 360));
    EXPECT_EQ(countAll(RayMark::Visible), 360) << turn_deg;
  }
}

// A post hides the wall behind it where the seam of r (which looks away) runs through both.
//
//    wall 1 |                 c
//           |      | post     r ->
TEST_F(ProjectionTest, SurfaceAcrossTheSeamHides)
{
  const std::vector<Wall> walls = {{{-2, -0.5}, {-2, 0.5}}, {{-5, -3}, {-5, 3}}};
  project(walls, {0, 1.5, 0}, BeamGrid::centered(2 * kPi, 720));
  EXPECT_GT(count(1, RayMark::Hidden), 10);
  for (std::size_t i = 0; i < rays_.size(); ++i)
    if (projection_.mark[i] == RayMark::Hidden)
    {
      EXPECT_LT(std::abs(projection_.y_m[i]), 1.3);
    }
}

// The rays of a coarse reference on both sides of a corner are nearer than the corner, and yet no
// surface hides it.
TEST_F(ProjectionTest, CornerBetweenTwoReferenceRaysIsNotHidden)
{
  const std::vector<Wall> walls = squareRoom();
  project(walls, {}, BeamGrid::centered(2 * kPi, 360));
  reference_.grid = BeamGrid(-kPi, degToRad(8), 45);
  projectScan(rays_, current_, {}, reference_, projection_);
  EXPECT_EQ(countAll(RayMark::Visible), 360);
}

TEST_F(ProjectionTest, PointsBeyondTheReferencesRangeAreMarked)
{
  const std::vector<Wall> walls = {{{6, -2}, {6, 2}}};
  project(walls, {2, 0, 0}, BeamGrid::centered(kPi, 181));
  reference_.maxRange_m = 5;
  projectScan(rays_, current_, {2, 0, 0}, reference_, projection_);
  EXPECT_EQ(countAll(RayMark::BeyondRange), static_cast<int>(rays_.size()));
}

TEST_F(ProjectionTest, EmptyScansAreFine)
{
  project({}, {1, 2, 3}, BeamGrid::centered(kPi, 3));
  EXPECT_EQ(rays_.size(), 0U);
  project({}, {1, 2, 3}, BeamGrid());
  EXPECT_EQ(rays_.size(), 0U);
}
}  // namespace
}  // namespace psmks
