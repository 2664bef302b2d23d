/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/LineFilters.h>
#include <psmks/segmentation/LineFit.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
constexpr double kSigma_m = 0.01;

MeasuredRay rayOf(double bearing_rad, double range_m)
{
  return {std::cos(bearing_rad), std::sin(bearing_rad), range_m, 1 / range_m};
}

/** Consecutive noisy rays, one degree apart, about the foot of a line. */
std::vector<MeasuredRay> inlierRays(const Line& line, int count, test::RandomNumbers& random)
{
  std::vector<MeasuredRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const double bearing_rad = line.phi0_rad + degToRad(i - 0.5 * count);
    rays.push_back(rayOf(bearing_rad, line.rangeAt_m(bearing_rad) + random.normal(kSigma_m)));
  }
  return rays;
}

template <class Filter>
bool startOn(Filter& filter, const std::vector<MeasuredRay>& rays, int seedRays)
{
  LineInformation seed;
  for (int i = 0; i < seedRays; ++i) seed.add(rays[static_cast<std::size_t>(i)]);
  return filter.start(seed);
}

/** A filter started on the first rays and updated by the others up to `end`. */
template <class Filter>
bool runOn(Filter& filter, const std::vector<MeasuredRay>& rays, std::size_t seedRays,
           std::size_t end)
{
  LineInformation sums;
  for (std::size_t i = 0; i < seedRays; ++i) sums.add(rays[i]);
  if (!filter.start(sums)) return false;
  for (std::size_t i = seedRays; i < end; ++i)
  {
    sums.add(rays[i]);
    filter.update(rays[i], sums);
  }
  return true;
}

template <class Filter>
class LineFilters : public testing::Test
{
};
using Filters = testing::Types<LinearLineFilter, PolarLineFilter>;
TYPED_TEST_SUITE(LineFilters, Filters, );
}  // namespace

// The innovation of the next ray is as large as the filter says: within one standard deviation in
// 68.3 %, within two in 95.4 % of the cases, after few rays as after many.
TEST(LinearLineFilter, PredictionIsConsistent)
{
  test::RandomNumbers random(21);
  SCOPED_TRACE(random.seedText());
  constexpr int kWalls = 4000;
  for (const int updates : {0, 8, 30})
  {
    int withinOne = 0, withinTwo = 0;
    for (int wall = 0; wall < kWalls; ++wall)
    {
      const Line line{random.uniform(1, 5), random.uniform(-kPi, kPi), {}};
      const std::vector<MeasuredRay> rays = inlierRays(line, 6 + updates + 1, random);
      LinearLineFilter filter({kSigma_m});
      ASSERT_TRUE(runOn(filter, rays, 6, static_cast<std::size_t>(6 + updates)));
      withinOne += filter.accepts(rays.back(), 1);
      withinTwo += filter.accepts(rays.back(), 2);
    }
    EXPECT_NEAR(withinOne / double{kWalls}, 0.683, 0.03) << "after " << updates << " updates";
    EXPECT_NEAR(withinTwo / double{kWalls}, 0.954, 0.015) << "after " << updates << " updates";
  }
}

TYPED_TEST(LineFilters, AcceptARayOnTheLineAndRefuseOneBesideIt)
{
  test::RandomNumbers random(22);
  SCOPED_TRACE(random.seedText());
  const Line line{2, 0.4, {}};
  const std::vector<MeasuredRay> rays = inlierRays(line, 30, random);
  TypeParam filter({kSigma_m});
  ASSERT_TRUE(runOn(filter, rays, 6, rays.size()));
  const double next_rad = line.phi0_rad + degToRad(16), next_m = line.rangeAt_m(next_rad);
  EXPECT_TRUE(filter.accepts(rayOf(next_rad, next_m), 3.3));
  EXPECT_FALSE(filter.accepts(rayOf(next_rad, next_m + 0.06), 3.3));
  EXPECT_FALSE(filter.accepts(rayOf(next_rad, next_m - 0.06), 3.3));
}

// A wall 2 m away, looked along: where it is 8 m away, sigma is 1 cm or 8 cm.
TYPED_TEST(LineFilters, WidenTheirGateAsTheNoiseGrows)
{
  const Line line{2, 0, {}};
  std::vector<MeasuredRay> rays;
  for (int bearing_deg = 0; bearing_deg < 75; ++bearing_deg)
    rays.push_back(rayOf(degToRad(bearing_deg), line.rangeAt_m(degToRad(bearing_deg))));
  TypeParam even({0.01}), growing({0.01, 0.01});
  ASSERT_TRUE(runOn(even, rays, 6, rays.size()));
  ASSERT_TRUE(runOn(growing, rays, 6, rays.size()));
  const double far_rad = std::acos(2.0 / 8);
  EXPECT_FALSE(even.accepts(rayOf(far_rad, 8.25), 3.3));
  EXPECT_TRUE(growing.accepts(rayOf(far_rad, 8.25), 3.3));
  EXPECT_FALSE(growing.accepts(rayOf(0, 2.09), 3.3));
}

TYPED_TEST(LineFilters, RefuseARayThatRunsAwayFromTheLine)
{
  test::RandomNumbers random(23);
  SCOPED_TRACE(random.seedText());
  const Line line{2, 0, {}};
  TypeParam filter({kSigma_m});
  ASSERT_TRUE(startOn(filter, inlierRays(line, 10, random), 10));
  EXPECT_FALSE(filter.accepts(rayOf(degToRad(179), 2), 3.3));
  EXPECT_FALSE(filter.accepts(rayOf(degToRad(91), 1e4), 3.3));
}

//   o o o o o o|. . . .     a block is accepted where each of its rays is
TEST(LinearLineFilter, ABlockIsAcceptedWhereEveryRayIs)
{
  test::RandomNumbers random(24);
  SCOPED_TRACE(random.seedText());
  int accepted = 0;
  for (int wall = 0; wall < 500; ++wall)
  {
    const Line line{random.uniform(1, 5), random.uniform(-0.5, 0.5), {}};
    SegmentedScan scan;
    scan.grid = BeamGrid::centered(degToRad(40), 41);
    for (int i = 0; i < 41; ++i)
      scan.range_m.push_back(line.rangeAt_m(scan.grid.bearing_rad(i)) +
                             random.normal(2 * kSigma_m));
    RaySoA columns;
    columns.load(scan);
    LineInformation seed;
    for (int p = 0; p < 20; ++p) seed.add(columns.measured(p));
    LinearLineFilter filter({kSigma_m});
    ASSERT_TRUE(filter.start(seed));
    bool every = true;
    for (int p = 20; p < 20 + RaySoA::kBlock; ++p)
      every = every && filter.accepts(columns.measured(p), 3);
    EXPECT_EQ(filter.acceptsBlock(columns, 20, 3), every);
    accepted += every;
  }
  // The noise is twice what the filter believes, so that both outcomes are frequent: a ray passes
  // its gate of 3 sigma with a probability of 0.87, all four of a block with 0.56, 282 of 500 walls
  // with a standard deviation of 11.
  EXPECT_NEAR(accepted, 282, 5 * 11);
}

TYPED_TEST(LineFilters, DoNotStartFromOneDirection)
{
  TypeParam filter({kSigma_m});
  LineInformation seed;
  seed.add(rayOf(0.2, 2));
  seed.add(rayOf(0.2, 2));
  EXPECT_FALSE(filter.start(seed));
}

// A frontal wall of 80 rays, where the early linearisation of the extended filter does little harm.
TEST(PolarLineFilter, EndsNearTheBatchFitOfAWellConditionedWall)
{
  const std::vector<Wall> walls = {{{2, -5}, {2, 5}}};
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 rng(seed);
    const BeamGrid grid = BeamGrid::centered(degToRad(79), 80);
    const Scan scan = castScan(walls, {}, grid, 30, kSigma_m, rng);
    RaySoA columns;
    columns.load(segmentByWalls(scan, walls, {}));
    std::fill_n(columns.mark.begin(), 80, 0);
    const LineFit batch = fitLine(columns, {0, 79, 0, 80}, {{1, 0}, 2});

    std::vector<MeasuredRay> rays;
    for (int i = 0; i < grid.count(); ++i)
      rays.push_back(rayOf(grid.bearing_rad(i), scan.range_m[static_cast<std::size_t>(i)]));
    PolarLineFilter filter({kSigma_m});
    ASSERT_TRUE(runOn(filter, rays, 12, rays.size()));

    const Line line = filter.line();
    const Eigen::Matrix2d& P = batch.line.covariance;
    EXPECT_NEAR(line.r0_m, batch.line.r0_m, std::sqrt(P(0, 0))) << "seed " << seed;
    EXPECT_NEAR(line.phi0_rad, batch.line.phi0_rad, std::sqrt(P(1, 1))) << "seed " << seed;
    EXPECT_NEAR(line.covariance(0, 0) / P(0, 0), 1, 0.1) << "seed " << seed;
    EXPECT_NEAR(line.covariance(1, 1) / P(1, 1), 1, 0.1) << "seed " << seed;
  }
}
}  // namespace psmks
