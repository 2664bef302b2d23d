/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/ScanFeatures.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
constexpr float kTolerance_m = 0.05f;

/** Points given one by one. */
RayPoints pointsAt(const std::vector<Eigen::Vector2f>& points_m, bool movable = false)
{
  RayPoints points;
  for (const Eigen::Vector2f& p : points_m)
  {
    points.x_m.push_back(p.x());
    points.y_m.push_back(p.y());
    points.movable.push_back(movable);
  }
  return points;
}

//             |
//    o  [P]   |  a wall at x = 3 m, and from bearing 26 to 45 degrees a person in front of it;
//             |  nothing returns below -45 degrees
class FreeSpaceScore : public testing::Test
{
 protected:
  FreeSpaceScore()
  {
    std::vector<Wall> walls = {{{3, -3}, {3, 20}}};
    for (const Wall& side : box({1.2, 0.8}, 0.3, 0.3)) walls.push_back(side);
    const BeamGrid grid = BeamGrid::centered(kPi, 181);
    scan_ = segmentByWalls(castScan(walls, {}, grid), walls, {});
    view_.build(scan_);
  }

  RayCounts count(const RayPoints& points, const Pose2& T = {}, int stride = 1) const
  {
    return countRays(points, view_.surface, T, kTolerance_m, stride);
  }

  SegmentedScan scan_;
  ScanFeatures view_;
};

void expectCounts(const RayCounts& n, const RayCounts& expected)
{
  EXPECT_EQ(n.on, expected.on);
  EXPECT_EQ(n.front, expected.front);
  EXPECT_EQ(n.behind, expected.behind);
  EXPECT_EQ(n.moved, expected.moved);
  EXPECT_EQ(n.uncovered, expected.uncovered);
  EXPECT_EQ(n.unknown, expected.unknown);
}

RayCounts counts(int on, int front, int behind, int moved, int uncovered, int unknown)
{
  RayCounts n;
  n.on = on, n.front = front, n.behind = behind;
  n.moved = moved, n.uncovered = uncovered, n.unknown = unknown;
  return n;
}
}  // namespace

TEST_F(FreeSpaceScore, PointsOnTheWallAreOn)
{
  expectCounts(count(pointsAt({{3, 0}, {3.04f, -1}, {2.96f, -2}})), counts(3, 0, 0, 0, 0, 0));
}

TEST_F(FreeSpaceScore, PointsBeforeTheWallAreInFront)
{
  expectCounts(count(pointsAt({{2.9f, 0}, {1, -0.5f}})), counts(0, 2, 0, 0, 0, 0));
}

TEST_F(FreeSpaceScore, PointsBeyondTheWallAreBehind)
{
  expectCounts(count(pointsAt({{3.1f, 0}, {9, -1}})), counts(0, 0, 2, 0, 0, 0));
}

TEST_F(FreeSpaceScore, AMovableObjectBeforeTheWallMayHaveMovedThere)
{
  expectCounts(count(pointsAt({{2, 0}}, true)), counts(0, 0, 0, 1, 0, 0));
}

TEST_F(FreeSpaceScore, AWallBehindAMovableObjectMayHaveBeenUncovered)
{
  expectCounts(count(pointsAt({{3, 2.1f}})), counts(0, 0, 0, 0, 1, 0));
}

TEST_F(FreeSpaceScore, OutsideTheViewAndWithoutAReturnNothingIsKnown)
{
  expectCounts(count(pointsAt({{-1, 0}, {1, -2}})), counts(0, 0, 0, 0, 0, 2));
}

TEST_F(FreeSpaceScore, PointsAreMovedByThePose)
{
  // (0, -3) turned by a quarter is (3, 0), and 0.5 m farther it is behind the wall.
  expectCounts(count(pointsAt({{0, -3}}), {0, 0, kPi / 2}), counts(1, 0, 0, 0, 0, 0));
  expectCounts(count(pointsAt({{0, -3}}), {0.5, 0, kPi / 2}), counts(0, 0, 1, 0, 0, 0));
}

TEST_F(FreeSpaceScore, AStrideTakesEveryNthPoint)
{
  const std::vector<Eigen::Vector2f> onAndFront = {{3, 0}, {2, 0}, {3, -1}, {2, -1}, {3, -2}};
  expectCounts(count(pointsAt(onAndFront), {}, 2), counts(3, 0, 0, 0, 0, 0));
}

TEST_F(FreeSpaceScore, MorePointsThanOneBlockAreAllCounted)
{
  const std::vector<Eigen::Vector2f> many(203, Eigen::Vector2f(3, 0));
  expectCounts(count(pointsAt(many)), counts(203, 0, 0, 0, 0, 0));
  expectCounts(count(pointsAt(many), {}, 4), counts(51, 0, 0, 0, 0, 0));
}

TEST(FreeSpaceScoreValue, FollowsItsFormula)
{
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(10, 0, 0, 0, 0, 0)), 1);
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 2, 0, 0, 0, 0)), 6.0 / 8);
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 2, 0, 0, 0)), 6.0 / 7);
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 0, 2, 0, 0)), 6.0 / 7);
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 0, 0, 2, 0)), 6.0 / 6.5);
}

TEST(FreeSpaceScoreValue, FallsWhereLittleIsSeen)
{
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(4, 0, 0, 0, 0, 6)), 1) << "40 % seen is enough";
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(2, 0, 0, 0, 0, 8)), 0.5);
}

TEST(FreeSpaceScoreValue, IsZeroWithoutEvidence)
{
  EXPECT_EQ(freeSpaceScore({}), 0);
  EXPECT_EQ(freeSpaceScore(counts(0, 0, 0, 0, 0, 9)), 0);
}
}  // namespace psmks
