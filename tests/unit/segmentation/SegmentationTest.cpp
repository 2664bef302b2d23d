/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/Segmentation.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <algorithm>

namespace psmks
{
namespace
{
SegmentedScan segmentsOf(const Scan& scan, const SegmentationOptions& options = {})
{
  SegmentationBuffers buffers;
  SegmentedScan result;
  segmentScan(scan, {}, options, buffers, result);
  return result;
}

/** What holds of every segmentation: bounds, order, and rays that agree with their segments. */
void expectConsistent(const SegmentedScan& scan)
{
  std::vector<int> rays(scan.segments.size(), 0);
  for (int i = 0; i < scan.rays(); ++i)
  {
    const int s = scan.segmentOfRay[static_cast<std::size_t>(i)];
    if (s == SegmentedScan::kNoSegment) continue;
    EXPECT_TRUE(scan.isValid(i)) << "ray " << i;
    ++rays[static_cast<std::size_t>(s)];
  }
  for (std::size_t s = 0; s < scan.segments.size(); ++s)
  {
    const Segment& segment = scan.segments[s];
    EXPECT_EQ(segment.rays, rays[s]) << "segment " << s;
    EXPECT_EQ(scan.segmentAt(segment.firstRay), &segment);
    EXPECT_EQ(scan.segmentAt(segment.lastRay), &segment);
    EXPECT_GT(segment.line.covariance.determinant(), 0);
    EXPECT_NEAR(segment.line.distance_m(segment.firstEnd_m), 0, 1e-9);
    EXPECT_NEAR(segment.line.distance_m(segment.lastEnd_m), 0, 1e-9);
  }
}

/** Ranges of a wall at x = 2 m, seen by the rays of an open grid, to be tampered with. */
Scan wallAhead(const BeamGrid& grid = BeamGrid::centered(degToRad(80), 81))
{
  return castScan({{{2, -30}, {2, 30}}}, {}, grid);
}

class Segmentation : public testing::TestWithParam<LineFilter>
{
 protected:
  SegmentedScan segmented(const Scan& scan) const
  {
    SegmentationOptions options;
    options.filter = GetParam();
    const SegmentedScan result = segmentsOf(scan, options);
    expectConsistent(result);
    return result;
  }
};

INSTANTIATE_TEST_SUITE_P(Filters, Segmentation,
                         testing::Values(LineFilter::Linear, LineFilter::Ekf),
                         [](const auto& filter) -> std::string
                         { return filter.param == LineFilter::Linear ? "Linear" : "Ekf"; });
}  // namespace

//            | wall x = 2
//     o      |
//            |
TEST_P(Segmentation, AWallIsOneSegmentWithItsLine)
{
  const SegmentedScan scan = segmented(wallAhead());
  ASSERT_EQ(scan.segments.size(), 1u);
  const Segment& wall = scan.segments[0];
  EXPECT_EQ(wall.firstRay, 0);
  EXPECT_EQ(wall.lastRay, 80);
  EXPECT_EQ(wall.rays, 81);
  EXPECT_NEAR(wall.line.r0_m, 2, 1e-9);
  EXPECT_NEAR(wall.line.phi0_rad, 0, 1e-9);
  EXPECT_NEAR(wall.sigma_m, 0, 1e-6);
  EXPECT_NEAR(wall.firstEnd_m.y(), -2 * std::tan(degToRad(40)), 1e-9);
  EXPECT_NEAR(wall.length_m(), 4 * std::tan(degToRad(40)), 1e-9);
}

//   +--------------+
//   |              |     every ray of a noisy room is on its own wall; the rays that hit a corner
//   |      o       |     may be on either
//   |              |
//   +--------------+
TEST_P(Segmentation, CornerRaysGoToTheLineThatExplainsThem)
{
  constexpr double kSigma_m = 0.004;
  const Pose2 T_world_sensor{0.3, -0.2, 0.1};
  int valid = 0, used = 0;
  for (const int fieldOfView_deg : {60, 90, 120, 180, 240, 270, 300, 360})
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      SCOPED_TRACE(std::to_string(fieldOfView_deg) + " degrees, seed " + std::to_string(seed));
      std::mt19937 rng(seed);
      const BeamGrid grid = BeamGrid::centered(degToRad(fieldOfView_deg), fieldOfView_deg);
      const Scan raw = castScan(squareRoom(), T_world_sensor, grid, 30, kSigma_m, rng);
      const SegmentedScan scan = segmented(raw);
      const SegmentedScan truth = segmentByWalls(raw, squareRoom(), T_world_sensor);
      EXPECT_EQ(scan.segments.size(), truth.segments.size());
      valid += grid.count();
      for (int i = 0; i < grid.count(); ++i)
      {
        const Segment* segment = scan.segmentAt(i);
        if (!segment) continue;
        ++used;
        const Segment* wall = truth.segmentAt(i);
        const bool own =
            wall && std::abs(wrapAngle(wall->line.phi0_rad - segment->line.phi0_rad)) < degToRad(5);
        const double off_m =
            segment->line.rangeAt_m(grid.bearing_rad(i)) - raw.range_m[static_cast<std::size_t>(i)];
        EXPECT_TRUE(own || std::abs(off_m) < 4 * kSigma_m)
            << "ray " << i << " is " << off_m << " m off its segment";
      }
    }
  EXPECT_GT(used, 0.98 * valid);
}

//            |
//     o   .  |     one ray in front of the wall, or behind it
//            |
TEST_P(Segmentation, AnIsolatedOutlierIsSurvived)
{
  for (const double outlier_m : {1.0, 5.0})
  {
    Scan raw = wallAhead();
    raw.range_m[30] = outlier_m;
    const SegmentedScan scan = segmented(raw);
    ASSERT_EQ(scan.segments.size(), 1u);
    EXPECT_EQ(scan.segments[0].rays, 80);
    EXPECT_EQ(scan.segments[0].firstRay, 0);
    EXPECT_EQ(scan.segments[0].lastRay, 80);
    EXPECT_EQ(scan.segmentAt(30), nullptr);
    EXPECT_NEAR(scan.segments[0].line.r0_m, 2, 1e-9);
  }
}

TEST_P(Segmentation, AnOutlierAtEitherEndIsNotPartOfTheSegment)
{
  Scan raw = wallAhead();
  raw.range_m.front() = raw.range_m.back() = 1;
  const SegmentedScan scan = segmented(raw);
  ASSERT_EQ(scan.segments.size(), 1u);
  EXPECT_EQ(scan.segments[0].firstRay, 1);
  EXPECT_EQ(scan.segments[0].lastRay, 79);
}

//            |
//     o   [] |     a narrow object hides three rays of the wall: its two sides are one wall
//            |     to the merging; a wider one keeps them apart
TEST_P(Segmentation, CollinearNeighboursMergeAcrossFewRays)
{
  for (const int hidden : {2, 3, 5})
  {
    Scan raw = wallAhead();
    for (int i = 40; i < 40 + hidden; ++i) raw.range_m[static_cast<std::size_t>(i)] = 1;
    const SegmentedScan scan = segmented(raw);
    EXPECT_EQ(scan.segments.size(), hidden <= 3 ? 1u : 2u) << hidden << " hidden rays";
    for (int i = 40; i < 40 + hidden; ++i) EXPECT_EQ(scan.segmentAt(i), nullptr);
  }
}

//             | x = 2.05
//     o      |  x = 2
//            |
TEST_P(Segmentation, CollinearNeighboursFiveCentimetresApartStayTwo)
{
  const std::vector<Wall> walls = {{{2, -30}, {2, 0.01}}, {{2.05, 0.01}, {2.05, 30}}};
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    std::mt19937 rng(seed);
    const SegmentedScan scan =
        segmented(castScan(walls, {}, BeamGrid::centered(degToRad(80), 81), 30, 0.01, rng));
    ASSERT_EQ(scan.segments.size(), 2u) << "seed " << seed;
    const auto middleOf = [&](const Segment& segment) -> Eigen::Vector2d
    { return 0.5 * (segment.firstEnd_m + segment.lastEnd_m); };
    EXPECT_NEAR(middleOf(scan.segments[0]).x(), 2, 0.012) << "seed " << seed;
    EXPECT_NEAR(middleOf(scan.segments[1]).x(), 2.05, 0.012) << "seed " << seed;
  }
}

TEST_P(Segmentation, FewerThanSixRaysAreNoSegment)
{
  for (const int seen : {3, 4, 5, 6})
  {
    Scan raw = wallAhead();
    for (std::size_t i = 0; i < raw.range_m.size(); ++i)
      if (i < 40 || i >= 40u + static_cast<unsigned>(seen)) raw.range_m[i] = 0;
    EXPECT_EQ(segmented(raw).segments.size(), seen < 6 ? 0u : 1u) << seen << " rays";
  }
}

//          . o .
//         o     o     a round pillar, 2 m away
//
//            o
TEST_P(Segmentation, ARoundPillarIsNoSegment)
{
  const double radius_m = 0.5, centre_m = 2.5;
  Scan raw;
  raw.grid = BeamGrid::centered(degToRad(60), 241);
  raw.maxRange_m = 30;
  raw.rangeSigma_m = 0.002;
  for (int i = 0; i < raw.grid.count(); ++i)
  {
    const double b = raw.grid.bearing_rad(i);
    const double half2_m2 = radius_m * radius_m - std::pow(centre_m * std::sin(b), 2);
    raw.range_m.push_back(half2_m2 > 0 ? centre_m * std::cos(b) - std::sqrt(half2_m2) : 30);
  }
  const SegmentedScan scan = segmented(raw);
  ASSERT_GT(scan.validRays(), 80);
  // A piece of 17 cm bulges by 7 mm, of which the noise leaves enough to be seen.
  for (const Segment& segment : scan.segments)
    EXPECT_LT(segment.length_m(), 0.17)
        << "from ray " << segment.firstRay << " to " << segment.lastRay;
}

TEST_P(Segmentation, AHoleOfUpToThreeInvalidRaysIsBridged)
{
  for (const int missing : {1, 2, 3, 6})
  {
    Scan raw = wallAhead();
    for (int i = 40; i < 40 + missing; ++i) raw.range_m[static_cast<std::size_t>(i)] = 0;
    const SegmentedScan scan = segmented(raw);
    ASSERT_EQ(scan.segments.size(), missing <= 3 ? 1u : 2u) << missing << " missing rays";
    EXPECT_EQ(scan.segments[0].firstRay, 0);
    EXPECT_EQ(scan.segments.back().lastRay, 80);
    EXPECT_EQ(scan.segments[0].rays + (missing <= 3 ? 0 : scan.segments[1].rays), 81 - missing);
  }
}

//   +--------------+
//   |              |
//   |      o --->  |     the seam of the closed scan is in the middle of the wall behind
//   |              |
//   +--------------+
TEST_P(Segmentation, AWallAcrossTheSeamIsOneSegment)
{
  std::mt19937 rng(1);
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const SegmentedScan scan = segmented(castScan(squareRoom(), {0.3, 0.2, 0}, grid, 30, 0.005, rng));
  ASSERT_EQ(scan.segments.size(), 4u);
  const Segment* behind = scan.segmentAt(0);
  ASSERT_NE(behind, nullptr);
  EXPECT_EQ(scan.segmentAt(359), behind);
  EXPECT_LT(behind->lastRay, behind->firstRay);
  EXPECT_NEAR(behind->line.r0_m, 3.3, 0.01);
  EXPECT_NEAR(std::abs(behind->line.phi0_rad), kPi, 0.01);
}

TEST_P(Segmentation, AClosedScanOfOneLongWallIsOneSegment)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const SegmentedScan scan = segmented(castScan({{{-2, -5}, {-2, 5}}}, {}, grid));
  ASSERT_EQ(scan.segments.size(), 1u);
  EXPECT_EQ(scan.segments[0].rays, scan.validRays());
  EXPECT_LT(scan.segments[0].lastRay, scan.segments[0].firstRay);
}

TEST_P(Segmentation, NoisyRoomsAreUsedAndTheirErrorsAreThoseStated)
{
  constexpr unsigned kRooms = 40;
  int valid = 0, used = 0, lines = 0;
  double error2 = 0;
  for (unsigned seed = 1; seed <= kRooms; ++seed)
  {
    std::mt19937 rng(seed);
    const std::vector<Wall> walls = clutteredRoom(seed);
    const BeamGrid grid = BeamGrid::centered(kPi, 181);
    const SegmentedScan scan = segmented(castScan(walls, {}, grid, 30, 0.01, rng));
    const SegmentedScan truth = segmentByWalls(castScan(walls, {}, grid), walls, {});
    valid += scan.validRays();
    for (const Segment& segment : scan.segments)
    {
      used += segment.rays;
      const int middle = (segment.firstRay + segment.lastRay) / 2;
      const Segment* wall = truth.segmentAt(middle);
      if (!wall || segment.rays < 20) continue;
      const Eigen::Vector2d e(segment.line.r0_m - wall->line.r0_m,
                              wrapAngle(segment.line.phi0_rad - wall->line.phi0_rad));
      error2 += e.dot(segment.line.covariance.inverse() * e);
      ++lines;
    }
  }
  EXPECT_GT(used, 0.9 * valid);
  ASSERT_GT(lines, 100);
  // The expectation is 2; the paper's filter is known to be optimistic.
  const double mean = error2 / lines;
  EXPECT_GT(mean, 1.3);
  EXPECT_LT(mean, GetParam() == LineFilter::Linear ? 2.8 : 8);
}

TEST(SegmentationOfBadScans, GivesNoSegmentAndNoException)
{
  Scan empty;
  EXPECT_TRUE(segmentsOf(empty).segments.empty());
  for (const int rays : {1, 2, 3})
  {
    Scan few;
    few.grid = BeamGrid::centered(degToRad(10), rays);
    few.range_m.assign(static_cast<std::size_t>(rays), 2);
    EXPECT_TRUE(segmentsOf(few).segments.empty()) << rays << " rays";
  }
  Scan nothing = wallAhead(BeamGrid::centered(2 * kPi, 360));
  nothing.range_m.assign(360, std::nan(""));
  EXPECT_TRUE(segmentsOf(nothing).segments.empty());
}

TEST(SegmentationSigma, IsTheScansOwnThenTheOptions)
{
  Scan raw = wallAhead();
  SegmentationOptions options;
  options.rangeSigma_m = 0.02;
  raw.rangeSigma_m = 0.03;
  EXPECT_EQ(segmentsOf(raw, options).rangeNoise.sigma_m, 0.03);
  raw.rangeSigma_m = 0;
  EXPECT_EQ(segmentsOf(raw, options).rangeNoise.sigma_m, 0.02);
}

TEST(SegmentationSigma, GrowsAsTheOptionsSay)
{
  Scan raw = wallAhead();
  SegmentationOptions options;
  options.rangeSigmaPerMetre_m = 0.02;
  raw.rangeSigma_m = 0.01;
  const SegmentedScan scan = segmentsOf(raw, options);
  EXPECT_EQ(scan.rangeNoise.sigma_m, 0.01);
  EXPECT_EQ(scan.rangeNoise.sigmaPerMetre_m, 0.02);
}

//   +-----------------+
//   |  s              |     walls from 1.5 to 12 m away, with a noise of 2 % of the range
//   +-----------------+
//
// Where the noise is known, each of the four walls is one segment, one of which chance may cut in
// two, and few rays are single: a gate of 3.3 sigma leaves one in a thousand, and a corner, where a
// ray may fit either wall or neither, no more than it is contested over, which is 8 on one side.
// Where all ranges count as known to 5 mm, the standard deviation of the noise is wider than the
// gate from 0.8 m on, and hardly any wall is found.
TEST(SegmentationSigma, WallsFarAwayStayWholeWhereTheirNoiseIsKnown)
{
  const std::vector<Wall> room = outline({{-1.5, -2}, {12, -2}, {12, 2}, {-1.5, 2}});
  const RangeNoise noise{0.005, 0.02};
  std::mt19937 rng(3);
  std::normal_distribution<double> unitNoise;
  Scan raw = castScan(room, {}, BeamGrid::centered(2 * kPi, 720));
  for (double& range_m : raw.range_m) range_m += noise.sigmaAt_m(range_m) * unitNoise(rng);
  raw.rangeSigma_m = noise.sigma_m;
  SegmentationOptions options;
  options.estimateRangeSigma = false;
  const auto raysInSegments = [&]
  {
    const std::vector<int> segmentOfRay = segmentsOf(raw, options).segmentOfRay;
    return 720 - std::count(segmentOfRay.begin(), segmentOfRay.end(), SegmentedScan::kNoSegment);
  };
  const auto whereUnknown = raysInSegments();
  options.rangeSigmaPerMetre_m = noise.sigmaPerMetre_m;
  constexpr int kAtCorners = 4 * 8;
  EXPECT_GE(raysInSegments(), 720 - kAtCorners);
  EXPECT_GE(raysInSegments() - whereUnknown, 720 / 4) << "many more than where it is not known";
  EXPECT_LE(segmentsOf(raw, options).segments.size(), 5u);
}

TEST(SegmentationSigma, IsRaisedToWhatTheScanShows)
{
  std::mt19937 rng(1);
  Scan raw = castScan(squareRoom(), {}, BeamGrid::centered(2 * kPi, 720), 30, 0.03, rng);
  raw.rangeSigma_m = 0.01;
  EXPECT_NEAR(segmentsOf(raw).rangeNoise.sigma_m, 0.03, 0.006);
  SegmentationOptions options;
  options.estimateRangeSigma = false;
  EXPECT_EQ(segmentsOf(raw, options).rangeNoise.sigma_m, 0.01);
}
}  // namespace psmks
