/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/CollinearityStatistic.h>
#include <psmks/segmentation/Preprocessing.h>
#include <tests/support/Scenes.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** A cleaned scan with what the tests of three rays need beside it. */
struct Prepared
{
  explicit Prepared(const Scan& raw, const RangeNoise& noise = {})
  {
    SegmentedScan scan;
    cleanScan(raw, {}, scan);
    scan.rangeNoise = noise;
    rays.load(scan);
  }

  double estimatedSigma_m()
  {
    std::vector<double> scratch;
    return estimateRangeSigma_m(rays, scratch);
  }

  RaySoA rays;
};

//      o
//       \          a slanted wall, far and grazing at one end
//   -----\------
const std::vector<Wall> kSlantedWall = {{{3, -6}, {0.5, 6}}};
}  // namespace

TEST(CollinearityStatistic, IsZeroOnAnExactLineWhateverTheLine)
{
  const Prepared p(castScan(kSlantedWall, {}, BeamGrid::centered(kPi, 181)));
  std::vector<double> statistics_m2;
  collinearityStatistics(p.rays, statistics_m2);
  ASSERT_GT(statistics_m2.size(), 100u);
  for (const double test_m2 : statistics_m2) EXPECT_LT(test_m2, 1e-24);
}

TEST(CollinearityStatistic, IsTheRangeErrorInUnitsOfItsOwnPropagation)
{
  // On a circle of radius 2 m all ranges are alike, and one raised by e changes its own test by
  // 2 cos(d) e / r^2, whose standard deviation is sqrt(1 + 4 cos(d)^2 + 1) sigma / r^2.
  Scan scan;
  scan.grid = BeamGrid::centered(degToRad(4), 5);
  scan.range_m = {2, 2, 2, 2, 2};
  const double e_m = 1e-6, cosine = std::cos(degToRad(1));
  Prepared plain(scan);
  scan.range_m[2] += e_m;
  Prepared raised(scan);
  std::vector<double> before_m2, after_m2;
  collinearityStatistics(plain.rays, before_m2);
  collinearityStatistics(raised.rays, after_m2);
  const double change_m = std::sqrt(after_m2[1]) - std::sqrt(before_m2[1]);
  EXPECT_NEAR(change_m, 2 * cosine * e_m / std::sqrt(2 + 4 * cosine * cosine), 1e-3 * e_m);
}

TEST(CollinearityStatistic, RaysBesideAnInvalidOneAreNotTested)
{
  Scan scan = castScan(kSlantedWall, {}, BeamGrid::centered(kPi / 3, 11));
  scan.range_m[5] = 0;
  const Prepared p(scan);
  std::vector<double> statistics_m2;
  collinearityStatistics(p.rays, statistics_m2);
  EXPECT_EQ(statistics_m2.size(), 9u - 3u);
}

TEST(CollinearityStatistic, TheNoiseOfAClutteredRoomIsSeenWithin15Percent)
{
  const BeamGrid grid = BeamGrid::centered(kPi, 721);
  constexpr unsigned kRooms = 10;
  for (const double sigma_m : {0.005, 0.01, 0.03})
  {
    double mean_m = 0;
    for (unsigned seed = 1; seed <= kRooms; ++seed)
    {
      std::mt19937 rng(seed);
      Prepared p(castScan(clutteredRoom(seed), {}, grid, 30, sigma_m, rng));
      const double estimated_m = p.estimatedSigma_m();
      EXPECT_NEAR(estimated_m, sigma_m, 0.25 * sigma_m) << "seed " << seed;
      mean_m += estimated_m / kRooms;
    }
    EXPECT_NEAR(mean_m, sigma_m, 0.15 * sigma_m);
  }
}

//   -   -   -   -   -     a fence 3 m ahead, its planks and gaps three rays wide
//  ___________________    the wall behind it: of three tests in a row two reach across an edge
//
TEST(CollinearityStatistic, TheNoiseIsSeenThroughAFenceOfEdges)
{
  constexpr unsigned kScans = 10;
  constexpr int kRaysOfPlank = 3;
  const BeamGrid grid = BeamGrid::centered(degToRad(120), 361);
  const Line fence{3, 0, Eigen::Matrix2d::Zero()}, wall{5, 0, Eigen::Matrix2d::Zero()};
  double mean_m = 0;
  for (unsigned seed = 1; seed <= kScans; ++seed)
  {
    std::mt19937 rng(seed);
    std::normal_distribution<double> noise_m(0, 0.01);
    Scan scan;
    scan.grid = grid;
    for (int ray = 0; ray < grid.count(); ++ray)
    {
      const Line& met = ray / kRaysOfPlank % 2 ? wall : fence;
      scan.range_m.push_back(met.rangeAt_m(grid.bearing_rad(ray)) + noise_m(rng));
    }
    Prepared p(scan);
    std::vector<double> statistics_m2;
    collinearityStatistics(p.rays, statistics_m2);
    const auto onEdges = std::count_if(statistics_m2.begin(), statistics_m2.end(),
                                       [](double test_m2) { return test_m2 > 0.1 * 0.1; });
    ASSERT_GT(onEdges, 0.6 * static_cast<double>(statistics_m2.size()));
    mean_m += p.estimatedSigma_m() / kScans;
  }
  EXPECT_NEAR(mean_m, 0.01, 0.001);
}

// Of the scan's noise the share is found by which it exceeds the stated one, near as far.
TEST(CollinearityStatistic, NoiseThatGrowsIsMeasuredByItsOwnLaw)
{
  const RangeNoise stated{0.005, 0.01}, real = stated.scaledTo(0.01);
  double mean_m = 0;
  constexpr unsigned kRooms = 10;
  for (unsigned seed = 1; seed <= kRooms; ++seed)
  {
    std::mt19937 rng(seed);
    std::normal_distribution<double> unitNoise;
    Scan scan = castScan(clutteredRoom(seed), {}, BeamGrid::centered(kPi, 721));
    for (double& range_m : scan.range_m) range_m += real.sigmaAt_m(range_m) * unitNoise(rng);
    mean_m += Prepared(scan, stated).estimatedSigma_m() / kRooms;
  }
  EXPECT_NEAR(mean_m, 0.01, 0.0015);
}

// The count never misses what the median would tell.
TEST(CollinearityStatistic, TheCountForeseesTheMedian)
{
  const BeamGrid grid = BeamGrid::centered(kPi, 361);
  for (const double sigma_m : {0.005, 0.01, 0.02, 0.04})
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      std::mt19937 rng(seed);
      Prepared p(castScan(clutteredRoom(seed), {}, grid, 30, sigma_m, rng));
      EXPECT_TRUE(mayShowNoiseAbove(p.rays, 0.9 * p.estimatedSigma_m())) << "seed " << seed;
      EXPECT_FALSE(mayShowNoiseAbove(p.rays, 2 * p.estimatedSigma_m())) << "seed " << seed;
    }
}

TEST(CollinearityStatistic, FewRaysShowNoNoise)
{
  std::mt19937 rng(1);
  Prepared p(castScan(kSlantedWall, {}, BeamGrid::centered(kPi / 4, 21), 30, 0.01, rng));
  EXPECT_EQ(p.estimatedSigma_m(), 0);
}

// A closed scan in the middle of a square room: the sharpest breaks are its corners.
TEST(CollinearityStatistic, TheStrongestBreakOfARoomIsACorner)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Prepared p(castScan(squareRoom(), {}, grid));
  const double bearing_deg = radToDeg(grid.bearing_rad(strongestBreak(p.rays)));
  EXPECT_NEAR(std::abs(std::remainder(bearing_deg - 45, 90)), 0, 1e-6);
}

TEST(CollinearityStatistic, ARayAfterAnInvalidOneIsABreak)
{
  Scan scan = castScan(squareRoom(), {}, BeamGrid::centered(2 * kPi, 360));
  scan.range_m[99] = 0;
  const Prepared p(scan);
  EXPECT_EQ(strongestBreak(p.rays), 100);
}
}  // namespace psmks
