/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/ScanFeatures.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <cmath>

namespace psmks
{
namespace
{
constexpr float kTolerance_m = 0.05f;

/** Points given one by one, of one look each. */
RayPoints pointsAt(const std::vector<Eigen::Vector2f>& points_m, bool movable = false)
{
  RayPoints points;
  for (const Eigen::Vector2f& p : points_m)
  {
    points.x_m.push_back(p.x());
    points.y_m.push_back(p.y());
    points.movable.push_back(movable);
    points.looks.push_back(1);
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

RayCounts counts(float on, float front, float behind, float moved, float uncovered, float unknown)
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

TEST_F(FreeSpaceScore, APointCountsByItsLooks)
{
  RayPoints points = pointsAt({{3, 0}, {3, -1}, {2, 0}, {4, 0}});
  points.looks = {0.5f, 0.25f, 0.125f, 0.75f};
  expectCounts(count(points), counts(0.75f, 0.125f, 0.75f, 0, 0, 0));
}

TEST_F(FreeSpaceScore, RaysAreCountedWhateverTheirLooks)
{
  RayPoints points = pointsAt({{3, 0}, {3, -1}, {2, 0}, {4, 0}, {-1, 0}});
  points.looks = {0.5f, 0.25f, 0.125f, 0.75f, 0.1f};
  const RayCounts n = count(points);
  EXPECT_EQ(n.raysOn, 2);
  EXPECT_EQ(n.rays, 5) << "and those of which nothing is known";
}

// Each point that is counted stands for those that are left out.
TEST_F(FreeSpaceScore, AStrideTakesEveryNthPointForAll)
{
  const std::vector<Eigen::Vector2f> onAndFront = {{3, 0}, {2, 0}, {3, -1}, {2, -1}, {3, -2}};
  const RayCounts n = count(pointsAt(onAndFront), {}, 2);
  expectCounts(n, counts(2 * 3, 0, 0, 0, 0, 0));
  EXPECT_EQ(n.raysOn, 3);
  EXPECT_EQ(n.rays, 3);
}

TEST_F(FreeSpaceScore, MorePointsThanOneBlockAreAllCounted)
{
  const std::vector<Eigen::Vector2f> many(203, Eigen::Vector2f(3, 0));
  expectCounts(count(pointsAt(many)), counts(203, 0, 0, 0, 0, 0));
  expectCounts(count(pointsAt(many), {}, 4), counts(4 * 51, 0, 0, 0, 0, 0));
  EXPECT_EQ(count(pointsAt(many)).rays, 203);
  EXPECT_EQ(count(pointsAt(many), {}, 4).raysOn, 51);
}

TEST(FreeSpaceScoreValue, CountsAreAdded)
{
  RayCounts a = counts(1, 2, 3, 4, 5, 6), b = counts(10, 20, 30, 40, 50, 60);
  a.raysOn = 7, a.rays = 8, b.raysOn = 70, b.rays = 80;
  a += b;
  expectCounts(a, counts(11, 22, 33, 44, 55, 66));
  EXPECT_EQ(a.raysOn, 77);
  EXPECT_EQ(a.rays, 88);
}

TEST(FreeSpaceScoreValue, FollowsItsFormula)
{
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(10, 0, 0, 0, 0, 0)), 1);
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 2, 0, 0, 0, 0)), 6.0 / (6 + 4 * 2));
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 2, 0, 0, 0)), 6.0 / (6 + 2));
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 0, 2, 0, 0)), 6.0 / (6 + 2 / 4.0));
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 0, 0, 0, 2, 0)), 6.0 / (6 + 2 / 4.0));
  EXPECT_DOUBLE_EQ(freeSpaceScore(counts(6, 1, 2, 2, 4, 0)), 6.0 / (6 + 4 + 2 + 6 / 4.0));
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

// ---- likelihood ---------------------------------------------------------------------------------

TEST(LogLikelihoodRatio, FollowsItsFormula)
{
  EXPECT_DOUBLE_EQ(logLikelihoodRatio({}), 0);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(10, 0, 0, 0, 0, 0)), 0.6 * 10);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(0, 1, 0, 0, 0, 0)), 0.6 * -4);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(0, 0, 1, 0, 0, 0)), 0.6 * -1);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(0, 0, 0, 1, 0, 0)), 0.6 * -0.25);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(0, 0, 0, 0, 1, 0)), 0.6 * -0.25);
  EXPECT_DOUBLE_EQ(logLikelihoodRatio(counts(0, 0, 0, 0, 0, 9)), 0) << "unknown says nothing";
}

// A place as a whole looks like another one or does not: more than 50 looks say no more than 50 of
// them, unknown ones among them.
TEST(LogLikelihoodRatio, OfManyLooksItIsThatOfFiftyOnAverage)
{
  EXPECT_NEAR(logLikelihoodRatio(counts(50, 0, 0, 0, 0, 0)), 0.6 * 50, 1e-5);
  EXPECT_NEAR(logLikelihoodRatio(counts(400, 0, 0, 0, 0, 0)), 0.6 * 50, 1e-5);
  EXPECT_NEAR(logLikelihoodRatio(counts(300, 20, 40, 10, 10, 20)),
              0.6 * (300 - 4 * 20 - 40 - 20 / 4.0) / 8, 1e-5);
}

// As much against the pose as for it, in whichever way.
TEST(LogLikelihoodRatio, IsZeroWhereTheScoreIsOneHalf)
{
  for (const RayCounts& even :
       {counts(4, 1, 0, 0, 0, 0), counts(3, 0, 3, 0, 0, 0), counts(1, 0, 0, 4, 0, 0),
        counts(1, 0, 0, 0, 4, 0), counts(7, 1, 2, 2, 2, 0), counts(7, 1, 2, 2, 2, 5)})
  {
    EXPECT_EQ(freeSpaceScore(even), 0.5);
    EXPECT_EQ(logLikelihoodRatio(even), 0);
  }
}

TEST(LogLikelihoodRatio, HasTheSignOfTheScoreBesideOneHalf)
{
  test::RandomNumbers random(7);
  SCOPED_TRACE(random.seedText());
  const auto looks = [&](double most) { return static_cast<float>(random.uniform(0, most)); };
  int speakFor = 0, speakAgainst = 0;
  for (int i = 0; i < 1000; ++i)
  {
    RayCounts n = counts(looks(40), looks(8), looks(15), looks(9), looks(9), 0);
    n.unknown = looks(1.4) * (n.on + n.front + n.behind + n.moved + n.uncovered);  // 40 % are seen
    const double ratio = logLikelihoodRatio(n), score = freeSpaceScore(n);
    if (std::abs(score - 0.5) < 1e-9) continue;
    EXPECT_EQ(ratio > 0, score > 0.5) << n.on << ' ' << n.front << ' ' << n.behind;
    ++(ratio > 0 ? speakFor : speakAgainst);
  }
  EXPECT_GT(speakFor, 100);
  EXPECT_GT(speakAgainst, 100);
}

//  |            |        |     free space up to a wall at 6 m; another scan sees a screen, 0.5 m
//  o            |   ..   |     wide, close by or far off
//  |            |        |
TEST(LogLikelihoodRatio, ANearObjectInFreeSpaceSpeaksNoMoreThanAFarOneOfTheSameSize)
{
  const BeamGrid grid = BeamGrid::centered(kPi, 361);
  const std::vector<Wall> wall{{{6, -30}, {6, 30}}};
  const SegmentedScan scan = segmentByWalls(castScan(wall, {}, grid), wall, {});
  ScanFeatures free;
  free.build(scan);
  const auto said = [&](double screen_m)
  {
    const std::vector<Wall> screen{{{screen_m, -0.25}, {screen_m, 0.25}}};
    RayPoints points;
    points.build(segmentByWalls(castScan(screen, {}, grid), screen, {}));
    return logLikelihoodRatio(countRays(points, free.surface, {}, kTolerance_m));
  };
  const double near = said(0.8), far = said(4);
  // Two looks in free space. Edges lie anywhere between two rays: of 3.5 cm at 4 m, 0.14 looks.
  EXPECT_NEAR(far, 0.6 * -4 * 2, 0.6 * 4 * 0.14);
  EXPECT_NEAR(near, far, 0.6 * 4 * 0.2) << "with five times as many rays";
}
}  // namespace psmks
