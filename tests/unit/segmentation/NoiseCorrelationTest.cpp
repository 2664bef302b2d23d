/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/NoiseCorrelation.h>
#include <psmks/segmentation/Segmentation.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace psmks
{
namespace
{
/** A wall 2 m ahead, seen by rays with a noise of 1 cm that is smoothed over some of them. */
SegmentedScan wallAhead(int smoothedRays, unsigned seed)
{
  constexpr int kRays = 181;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> white_m(0, 0.01);
  std::vector<double> noise_m(static_cast<std::size_t>(kRays + smoothedRays));
  for (double& n_m : noise_m) n_m = white_m(random);
  Scan scan;
  scan.grid = BeamGrid::centered(degToRad(90), kRays);
  scan.maxRange_m = 30;
  for (int ray = 0; ray < kRays; ++ray)
  {
    double sum_m = 0;
    for (int k = 0; k < smoothedRays; ++k) sum_m += noise_m[static_cast<std::size_t>(ray + k)];
    scan.range_m.push_back(2 / std::cos(scan.grid.bearing_rad(ray)) +
                           sum_m / std::sqrt(smoothedRays));
  }
  SegmentationOptions options;
  options.estimateRangeSigma = false;
  SegmentationBuffers buffers;
  SegmentedScan result;
  segmentScan(scan, {}, options, buffers, result);
  return result;
}

struct Means
{
  double raysPerReading = 0;
  double nees = 0;  //!< of whole walls, 2 where covariances are right
};

Means meansOver(int scans, int smoothedRays)
{
  Means means;
  int walls = 0;
  for (int seed = 0; seed < scans; ++seed)
  {
    const SegmentedScan scan = wallAhead(smoothedRays, static_cast<unsigned>(seed));
    means.raysPerReading += scan.raysPerReading / scans;
    if (scan.segments.size() != 1) continue;
    const Line& line = scan.segments[0].line;
    const Eigen::Vector2d error(line.r0_m - 2, line.phi0_rad);
    means.nees += error.dot(line.covariance.inverse() * error);
    ++walls;
  }
  means.nees /= walls;
  return means;
}
}  // namespace

TEST(NoiseCorrelation, IsNoneBeforeTheFirstLine)
{
  EXPECT_EQ(NoiseCorrelation().raysPerReading(), 1);
}

// chi2 of 100 rays is about 98, and the fit has taken 2 from the products: white noise. Products of
// two thirds of the squares: means of three, where the estimate was exact.
TEST(NoiseCorrelation, CountsTheRaysOfAMean)
{
  LineFit fit;
  fit.rays = 10000;
  fit.chi2 = 9998;
  fit.whiteness = -2 / std::sqrt(fit.rays);
  NoiseCorrelation white, smoothed;
  white.add(fit);
  EXPECT_EQ(white.raysPerReading(), 1);
  fit.whiteness = (2.0 / 3 * fit.chi2 - 2) / std::sqrt(fit.rays);
  smoothed.add(fit);
  EXPECT_NEAR(smoothed.raysPerReading(), 3, 0.1);
  EXPECT_LT(smoothed.raysPerReading(), 3) << "a standard deviation is left out";
}

TEST(NoiseCorrelation, WhiteNoiseLeavesLinesAsTheyAre)
{
  const Means means = meansOver(400, 1);
  EXPECT_LT(means.raysPerReading, 1.05);
  EXPECT_NEAR(means.nees, 2, 0.3);
}

TEST(NoiseCorrelation, LinesOfASmoothingScannerAreAsUncertainAsTheySay)
{
  const Means means = meansOver(400, 3);
  EXPECT_NEAR(means.raysPerReading, 2.5, 0.5);
  EXPECT_NEAR(means.nees, 2.3, 0.6);
}
}  // namespace psmks
