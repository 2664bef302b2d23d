/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/paper/Association.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
/** Tests of the associations between a scan of a room from the origin and one from
 * `T_world_current`, at a given pose. */
class AssociationTest : public testing::Test
{
 protected:
  void scan(const std::vector<Wall>& walls, const Pose2& T_world_current,
            const BeamGrid& grid = BeamGrid::centered(2 * kPi, 360))
  {
    reference_ = segmentByWalls(castScan(walls, {}, grid), walls, {});
    current_ = segmentByWalls(castScan(walls, T_world_current, grid), walls, T_world_current);
    rays_.assign(current_);
  }

  void associateAt(const Pose2& T_ref_cur, double gateOrientation_rad)
  {
    projectScan(rays_, current_, T_ref_cur, reference_, projection_);
    associate(rays_, projection_, current_, reference_, gateOrientation_rad, options_,
              associations_);
  }

  void associateAt(const Pose2& T_ref_cur) { associateAt(T_ref_cur, T_ref_cur.phi_rad); }

  std::size_t pairs() const { return associations_.pairs.size(); }

  SegmentedScan reference_, current_;
  DenoisedRays rays_;
  Projection projection_;
  PaperOptions options_;
  Associations associations_;
};

TEST_F(AssociationTest, AtTheTruePoseEveryRayMeetsItsOwnWallWithoutError)
{
  const Pose2 T{0.4, -0.3, 0.2};
  scan(squareRoom(), T);
  associateAt(T);
  EXPECT_EQ(pairs(), 360U);
  EXPECT_EQ(associations_.refused, 0);
  for (const Association& a : associations_.pairs) EXPECT_NEAR(a.residual_m, 0, 1e-9);
}

//   One wall at x = 3. Moved by dx, a ray at bearing b reads the wall at 3 / cos b; nothing is
//   rounded to the grid of the reference, however coarse.
TEST_F(AssociationTest, ReferenceValueIsThatOfTheLineEquation)
{
  const std::vector<Wall> walls = {{{3, -4}, {3, 4}}};
  scan(walls, {}, BeamGrid::centered(degToRad(100), 26));
  const Pose2 supposed{0.05, 0.013, 0.01};
  associateAt(supposed);
  ASSERT_GT(pairs(), 20U);
  for (const Association& a : associations_.pairs)
  {
    const double x = projection_.x_m[a.ray], y = projection_.y_m[a.ray];
    const double bearing_rad = std::atan2(y, x);
    EXPECT_NEAR(a.residual_m, 3 / std::cos(bearing_rad) - std::hypot(x, y), 1e-9);
    EXPECT_NEAR(a.incidenceCosine, std::cos(bearing_rad), 1e-9);
  }
}

TEST_F(AssociationTest, RadiusGateSeparatesParallelWalls)
{
  const std::vector<Wall> walls = {{{3, -2}, {3, 2}}};
  scan(walls, {});
  associateAt({0.19, 0, 0});
  EXPECT_GT(pairs(), 0U);
  associateAt({0.21, 0, 0});
  EXPECT_EQ(pairs(), 0U);
  EXPECT_GT(associations_.refused, 0);
}

TEST_F(AssociationTest, AngleGateIsTestedAtTheStatedOrientation)
{
  const std::vector<Wall> walls = {{{3, -2}, {3, 2}}};
  scan(walls, {});
  associateAt({0, 0, degToRad(4.9)});
  EXPECT_GT(pairs(), 0U);
  associateAt({0, 0, degToRad(5.1)});
  EXPECT_EQ(pairs(), 0U);
  associateAt({0, 0, degToRad(5.1)}, 0);
  EXPECT_GT(pairs(), 0U);
  associateAt({0, 0, 0}, degToRad(5.1));
  EXPECT_EQ(pairs(), 0U);
}

TEST_F(AssociationTest, MahalanobisGateKnowsTheLinesCovariances)
{
  const std::vector<Wall> walls = {{{3, -2}, {3, 2}}};
  scan(walls, {});
  options_.mahalanobisGate = 3;
  const double sigma_m = std::sqrt(2 * current_.segments[0].line.covariance(0, 0));
  associateAt({2.5 * sigma_m, 0, 0});
  EXPECT_GT(pairs(), 0U);
  associateAt({3.5 * sigma_m, 0, 0});
  EXPECT_EQ(pairs(), 0U);
}

//   reference r and current c see the two sides of one thin wall:   r  |  c
TEST_F(AssociationTest, SidesOfAThinWallAreNotTheSame)
{
  const std::vector<Wall> walls = {{{0.02, -2}, {0.02, 2}}};
  const Pose2 T{0.04, 0, 0};
  scan(walls, T);
  associateAt(T);
  EXPECT_EQ(pairs(), 0U);
}

//        ----------+      In the corner of a room the last ray of one wall and the first of the
//                  |      next stand on either side of a gap. Both lines are extrapolated into it;
//         o        |      a current ray in the gap lies on one of them.
TEST_F(AssociationTest, BetweenSegmentsTheLineWithTheSmallerErrorIsKept)
{
  // A reference of 8 degree rays and a current one of 1 degree: many rays fall into the gaps.
  const std::vector<Wall> walls = squareRoom();
  reference_ = segmentByWalls(castScan(walls, {}, BeamGrid(-kPi, degToRad(8), 45)), walls, {});
  ASSERT_EQ(reference_.segments.size(), 4U);
  const BeamGrid fine = BeamGrid::centered(2 * kPi, 360);
  current_ = segmentByWalls(castScan(walls, {}, fine), walls, {});
  rays_.assign(current_);
  associateAt({});
  EXPECT_EQ(pairs(), 360U);
  for (const Association& a : associations_.pairs) EXPECT_NEAR(a.residual_m, 0, 1e-9);
}

TEST_F(AssociationTest, LineReachesLessThanOneRayBeyondItsEnd)
{
  const std::vector<Wall> walls = {{{3, -1}, {3, 1}}};
  scan(walls, {});
  const Segment& wall = reference_.segments[0];
  // The sensor's heading shifts the current rays by 3: beyond the reference's last ray.
  associateAt({0, 0, degToRad(3)});
  double furthest = 0;
  for (const Association& a : associations_.pairs)
    furthest = std::max(furthest, projection_.index[a.ray]);
  EXPECT_LT(furthest, wall.lastRay + 1);
  EXPECT_LT(pairs(), static_cast<std::size_t>(wall.rays));
}

TEST_F(AssociationTest, SinglePointsAreNotAssociated)
{
  scan(squareRoom(), {});
  std::fill(current_.segmentOfRay.begin(), current_.segmentOfRay.end(), SegmentedScan::kNoSegment);
  rays_.assign(current_);
  associateAt({});
  EXPECT_EQ(pairs(), 0U);
  EXPECT_EQ(associations_.refused, 0);
}
}  // namespace
}  // namespace psmks
