/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/CollinearityStatistic.h>
#include <psmks/segmentation/LineGrowing.h>
#include <psmks/segmentation/Preprocessing.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
/** A scan between preprocessing and segments, with the runs of its lines. */
struct Workbench
{
  explicit Workbench(const Scan& raw, double sigma_m = 0.01)
  {
    SegmentedScan scan;
    cleanScan(raw, {}, scan);
    scan.rangeNoise = {sigma_m};
    rays.load(scan);
    if (scan.grid.closed()) rays.startAt(scan, strongestBreak(rays));
    rays.computeMoments();
  }

  LineGrowing lines() { return {options, rays, storage}; }

  int markOf(int ray) const
  {
    const int position = (ray - rays.ray(0) + rays.rays) % rays.rays;
    return rays.mark[static_cast<std::size_t>(position)];
  }

  SegmentationOptions options;
  RaySoA rays;
  std::vector<LineRun> storage;
};

/** A wall at x = 2 m; ray 40 of 81 looks straight at it, one degree apart. */
Scan wallAhead()
{
  return castScan({{{2, -30}, {2, 30}}}, {}, BeamGrid::centered(degToRad(80), 81));
}

void hide(Scan& scan, int first, int count, double range_m)
{
  for (int i = first; i < first + count; ++i) scan.range_m[static_cast<std::size_t>(i)] = range_m;
}
}  // namespace

TEST(LineGrowing, AWallGrowsFromEndToEnd)
{
  Workbench bench(wallAhead());
  LineGrowing lines = bench.lines();
  lines.grow();
  ASSERT_EQ(lines.runs().size(), 1u);
  EXPECT_EQ(lines.runs()[0].first, 0);
  EXPECT_EQ(lines.runs()[0].last, 80);
  EXPECT_EQ(lines.runs()[0].sums.rays(), 81);
}

//   ....x.....   one outlier is passed over          ....xx....   two end the line
TEST(LineGrowing, TwoConsecutiveOutliersEndALine)
{
  Scan one = wallAhead();
  hide(one, 40, 1, 1.0);
  Workbench survived(one);
  LineGrowing oneLine = survived.lines();
  oneLine.grow();
  ASSERT_EQ(oneLine.runs().size(), 1u);
  EXPECT_EQ(oneLine.runs()[0].sums.rays(), 80);
  EXPECT_EQ(survived.markOf(40), SegmentedScan::kNoSegment);

  Scan two = wallAhead();
  hide(two, 40, 2, 1.0);
  Workbench ended(two);
  LineGrowing twoLines = ended.lines();
  twoLines.grow();
  ASSERT_EQ(twoLines.runs().size(), 2u);
  EXPECT_EQ(twoLines.runs()[0].last, 39);
  EXPECT_EQ(twoLines.runs()[1].first, 42);
}

//   ....x.x....    the line ends before the first: the ray between the two is not its own
TEST(LineGrowing, ASecondOutlierSoonAfterTheFirstEndsTheLineBeforeTheFirst)
{
  Scan raw = wallAhead();
  hide(raw, 40, 1, 1.0);
  hide(raw, 42, 1, 1.0);
  Workbench bench(raw);
  LineGrowing lines = bench.lines();
  lines.grow();
  ASSERT_EQ(lines.runs().size(), 2u);
  EXPECT_EQ(lines.runs()[0].last, 39);
  EXPECT_EQ(lines.runs()[0].sums.rays(), 40);
  EXPECT_NE(bench.markOf(41), 0);
}

TEST(LineGrowing, ALineIsContinuedOverAHoleOfThreeRays)
{
  for (const int missing : {1, 3, 4})
  {
    Scan raw = wallAhead();
    hide(raw, 40, missing, 0.0);
    Workbench bench(raw);
    LineGrowing lines = bench.lines();
    lines.grow();
    EXPECT_EQ(lines.runs().size(), missing <= 3 ? 1u : 2u) << missing << " missing rays";
  }
}

// What a hidden piece of wall has torn apart is one line again; what is 5 cm apart is not.
TEST(LineGrowing, TouchingRunsMergeWhereOneLineExplainsBoth)
{
  Scan raw = wallAhead();
  hide(raw, 40, 2, 1.0);
  Workbench bench(raw);
  LineGrowing lines = bench.lines();
  lines.grow();
  lines.mergeCollinear();
  ASSERT_EQ(lines.runs().size(), 1u);
  EXPECT_EQ(lines.runs()[0].sums.rays(), 79);
  EXPECT_EQ(bench.markOf(80), 0);

  const std::vector<Wall> step = {{{2, -30}, {2, 0.01}}, {{2.05, 0.01}, {2.05, 30}}};
  Workbench stepped(castScan(step, {}, BeamGrid::centered(degToRad(80), 81)));
  LineGrowing panels = stepped.lines();
  panels.grow();
  panels.mergeCollinear();
  ASSERT_EQ(panels.runs().size(), 2u);
  EXPECT_EQ(stepped.markOf(0), 0);
  EXPECT_EQ(stepped.markOf(80), 1);
}

//          /     the line that grows first runs on past the blunt corner, as far as the gate
//     o   |      lets it; the contest gives the rays back
//         |
TEST(LineGrowing, TheContestPutsTheCornerWhereChi2IsSmallest)
{
  const std::vector<Wall> corner = {{{2, -30}, {2, 0.01}}, {{2, 0.01}, {1, 4}}};
  const BeamGrid grid = BeamGrid::centered(degToRad(100), 201);
  const std::vector<int> walls = wallsSeen(corner, {}, grid, 30);
  int wrongBefore = 0, wrongAfter = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 rng(seed);
    Workbench bench(castScan(corner, {}, grid, 30, 0.005, rng), 0.005);
    LineGrowing lines = bench.lines();
    const auto wrong = [&]
    {
      int count = 0;
      for (int i = 0; i < grid.count(); ++i)
        count += walls[static_cast<std::size_t>(i)] >= 0 &&
                 bench.markOf(i) != walls[static_cast<std::size_t>(i)];
      return count;
    };
    lines.grow();
    ASSERT_EQ(lines.runs().size(), 2u) << "seed " << seed;
    wrongBefore += wrong();
    lines.contestCorners();
    ASSERT_EQ(lines.runs().size(), 2u) << "seed " << seed;
    EXPECT_LT(lines.runs()[0].last, lines.runs()[1].first) << "seed " << seed;
    wrongAfter += wrong();
  }
  EXPECT_LT(wrongAfter, 0.7 * wrongBefore);
  EXPECT_LT(wrongAfter, 3 * 20) << "rays of 20 corners";
}

//   -------
//          -------     8 mm apart with a noise of 5 mm: no single ray shows the step
TEST(LineGrowing, ACutFindsTheStepThatNoRayShows)
{
  const std::vector<Wall> step = {{{2, -30}, {2, 0.01}}, {{2.008, 0.01}, {2.008, 30}}};
  const BeamGrid grid = BeamGrid::centered(degToRad(60), 241);
  std::mt19937 rng(1);
  Workbench bench(castScan(step, {}, grid, 30, 0.005, rng), 0.005);
  LineGrowing lines = bench.lines();
  LineRun run{0, 240, {}}, left, right;
  for (int ray = 0; ray < 241; ++ray)
  {
    bench.rays.mark[static_cast<std::size_t>(ray)] = 0;
    run.sums.add(bench.rays.measured(ray));
  }
  ASSERT_TRUE(lines.cut(run, 0, left, right));
  EXPECT_NEAR(left.last, 120, 12);
  EXPECT_EQ(right.first, left.last + 1);
  EXPECT_EQ(left.sums.rays() + right.sums.rays(), 241);
}

TEST(LineGrowing, AStraightWallIsNotCut)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 rng(seed);
    const Scan raw =
        castScan({{{2, -30}, {2, 30}}}, {}, BeamGrid::centered(degToRad(80), 81), 30, 0.01, rng);
    Workbench bench(raw);
    LineGrowing lines = bench.lines();
    lines.grow();
    ASSERT_EQ(lines.runs().size(), 1u) << "seed " << seed;
    LineRun left, right;
    EXPECT_FALSE(lines.cut(lines.runs()[0], 0, left, right)) << "seed " << seed;
  }
}

// On a closed scan positions start at a break, so a wall across the seam is one run.
TEST(LineGrowing, PositionsOfAClosedScanStartAtABreak)
{
  Workbench bench(castScan(squareRoom(), {0.3, 0.2, 0}, BeamGrid::centered(2 * kPi, 360)));
  LineGrowing lines = bench.lines();
  lines.grow();
  EXPECT_EQ(lines.runs().size(), 4u);
  EXPECT_NE(bench.rays.ray(0), 0);
  EXPECT_EQ(bench.rays.ray(359), bench.rays.ray(0) - 1);
  EXPECT_EQ(bench.markOf(0), bench.markOf(359));
}
}  // namespace psmks
