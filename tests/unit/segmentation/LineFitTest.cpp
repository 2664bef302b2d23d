/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/LineFit.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/LU>
#include <functional>

namespace psmks
{
namespace
{
constexpr double kSigma_m = 0.01;

/** All rays of a grid on one line, with ranges by bearing, from ray `start` on. */
RaySoA raysOf(const BeamGrid& grid, const std::function<double(double)>& rangeAt_m, int start = 0,
              const RangeNoise& noise = {kSigma_m})
{
  SegmentedScan scan;
  scan.rangeNoise = noise;
  scan.grid = grid;
  for (int i = 0; i < grid.count(); ++i) scan.range_m.push_back(rangeAt_m(grid.bearing_rad(i)));
  RaySoA rays;
  rays.load(scan);
  rays.startAt(scan, start);
  std::fill_n(rays.mark.begin(), rays.rays, 0);
  return rays;
}

RayRange allOf(const RaySoA& rays) { return {0, rays.rays - 1, 0, rays.rays}; }

LineStart startAt(const Line& line) { return {line.normal(), line.r0_m}; }

/** d range / d (r0, phi0) of every ray, by central differences of the line's own range. */
Eigen::MatrixX2d numericRows(const BeamGrid& grid, const Line& line)
{
  constexpr double h = 1e-6;
  Eigen::MatrixX2d J(grid.count(), 2);
  for (int i = 0; i < grid.count(); ++i)
  {
    const double b = grid.bearing_rad(i);
    const auto at = [&](double dr0, double dphi0) {
      return Line{line.r0_m + dr0, line.phi0_rad + dphi0, {}}.rangeAt_m(b);
    };
    J.row(i) << (at(h, 0) - at(-h, 0)) / (2 * h), (at(0, h) - at(0, -h)) / (2 * h);
  }
  return J;
}

const BeamGrid kGrid = BeamGrid::centered(degToRad(60), 61);
}  // namespace

TEST(LineFit, ExactRaysGiveTheirLine)
{
  const Line truth{2, 0.3, {}};
  const RaySoA rays = raysOf(kGrid, [&](double b) { return truth.rangeAt_m(b); });
  const LineFit fit = fitLine(rays, allOf(rays), startAt(truth));
  EXPECT_EQ(fit.rays, 61);
  EXPECT_NEAR(fit.line.r0_m, 2, 1e-12);
  EXPECT_NEAR(fit.line.phi0_rad, 0.3, 1e-12);
  EXPECT_NEAR(fit.chi2, 0, 1e-12);
  EXPECT_NEAR(fit.curvature_1_m, 0, 1e-9);
}

// The covariance, the step and chi2 hold all that the analytic rows can be seen by.
TEST(LineFit, StepAndCovarianceAreThoseOfTheNumericDerivative)
{
  test::RandomNumbers random(31);
  SCOPED_TRACE(random.seedText());
  for (int round = 0; round < 20; ++round)
  {
    const Line truth{random.uniform(0.5, 6), random.uniform(-0.6, 0.6), {}};
    const RaySoA rays =
        raysOf(kGrid, [&](double b) { return truth.rangeAt_m(b) + random.normal(kSigma_m); });
    const Line start{truth.r0_m + random.normal(0.003), truth.phi0_rad + random.normal(0.003), {}};
    const LineFit fit = fitLine(rays, allOf(rays), startAt(start));

    const Eigen::MatrixX2d J = numericRows(kGrid, start);
    Eigen::VectorXd e(rays.rays);
    for (int i = 0; i < rays.rays; ++i)
      e[i] = rays.range_m[static_cast<std::size_t>(i)] - start.rangeAt_m(kGrid.bearing_rad(i));
    const Eigen::Matrix2d inverse = (J.transpose() * J).inverse();
    const Eigen::Vector2d step = inverse * J.transpose() * e;
    EXPECT_NEAR(fit.line.r0_m - start.r0_m, step[0], 1e-8);
    EXPECT_NEAR(fit.line.phi0_rad - start.phi0_rad, step[1], 1e-8);
    const Eigen::Matrix2d covariance = kSigma_m * kSigma_m * inverse;
    EXPECT_LT((fit.line.covariance - covariance).norm(), 1e-6 * covariance.norm());
    EXPECT_NEAR(fit.chi2, (e - J * step).squaredNorm() / (kSigma_m * kSigma_m), 1e-4);
  }
}

//        |     rays at either end are far away and, here, noisy
//   o----|
//        |
TEST(LineFit, EveryRayCountsByItsOwnNoise)
{
  test::RandomNumbers random(35);
  SCOPED_TRACE(random.seedText());
  constexpr int kWalls = 2000;
  const RangeNoise noise{0.005, 0.02};
  const BeamGrid grid = BeamGrid::centered(degToRad(150), 61);
  const Line truth{2, 0, {}};
  double chi2 = 0, distance2 = 0, angle2 = 0, even2 = 0;
  for (int wall = 0; wall < kWalls; ++wall)
  {
    const auto range_m = [&](double b)
    {
      const double true_m = truth.rangeAt_m(b);
      return true_m + random.normal(noise.sigmaAt_m(true_m));
    };
    RaySoA rays = raysOf(grid, range_m, 0, noise);
    const LineFit fit = fitLine(rays, allOf(rays), startAt(truth));
    chi2 += fit.chi2 / (fit.rays - 2) / kWalls;
    const double off_m = fit.line.r0_m - truth.r0_m;
    distance2 += off_m * off_m / fit.line.covariance(0, 0) / kWalls;
    angle2 += fit.line.phi0_rad * fit.line.phi0_rad / fit.line.covariance(1, 1) / kWalls;
    rays.noise = {0.02};
    even2 += std::pow(fitLine(rays, allOf(rays), startAt(truth)).line.r0_m - truth.r0_m, 2) /
             fit.line.covariance(0, 0) / kWalls;
  }
  EXPECT_NEAR(chi2, 1, 0.02);
  EXPECT_NEAR(distance2, 1, 0.1);
  EXPECT_NEAR(angle2, 1, 0.1);
  EXPECT_GT(even2, 1.3) << "all rays alike are worse";
}

TEST(LineFit, OnlyMarkedRaysOfTheRangeCount)
{
  const Line truth{2, 0, {}};
  RaySoA rays = raysOf(kGrid, [&](double b) { return truth.rangeAt_m(b); });
  rays.range_m[20] = 1;  // passed over: another mark
  rays.mark[20] = SegmentedScan::kNoSegment;
  rays.range_m[5] = 1;  // before the range
  const LineFit fit = fitLine(rays, {10, 49, 0, 39}, startAt(truth));
  EXPECT_EQ(fit.rays, 39);
  EXPECT_NEAR(fit.line.r0_m, 2, 1e-12);
}

TEST(LineFit, ARangeGoesOnAcrossTheSeam)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Line truth{2, kPi, {}};  // the foot is at the seam
  const RaySoA rays = raysOf(
      grid, [&](double b) { return truth.rangeAt_m(b); }, 330);
  const LineFit fit = fitLine(rays, {0, 59, 0, 60}, startAt(truth));
  EXPECT_EQ(fit.rays, 60);
  EXPECT_NEAR(fit.line.r0_m, 2, 1e-12);
}

//        . o .
//     o         o       a round pillar of 3 m radius whose nearest point is 2 m away:
//                       at `along` from there it is along^2 / (2 * 3 m) farther than its tangent
//          scanner
TEST(LineFit, TheCurvatureOfARoundWallIsMeasured)
{
  const double radius_m = 3, centre_m = 5;
  const auto pillar = [&](double b)
  {
    return centre_m * std::cos(b) -
           std::sqrt(radius_m * radius_m - std::pow(centre_m * std::sin(b), 2));
  };
  test::RandomNumbers random(32);
  SCOPED_TRACE(random.seedText());
  const RaySoA rays =
      raysOf(BeamGrid::centered(degToRad(20), 61),
             [&](double b) { return pillar(b) + random.normal(0.002); }, 0, {0.002});
  const LineFit fit = fitLine(rays, allOf(rays), {{1, 0}, 2.01});
  EXPECT_GT(fit.curvature_1_m, 4.5 * fit.curvatureSigma_1_m);
  EXPECT_NEAR(fit.curvature_1_m, 1 / (2 * radius_m), 0.02);
}

TEST(LineFit, AWallHasNoCurvatureAndWhiteResiduals)
{
  test::RandomNumbers random(33);
  SCOPED_TRACE(random.seedText());
  constexpr int kWalls = 2000;
  double curvature2 = 0, whiteness = 0, whiteness2 = 0;
  for (int wall = 0; wall < kWalls; ++wall)
  {
    const Line truth{random.uniform(1, 4), random.uniform(-0.4, 0.4), {}};
    const RaySoA rays =
        raysOf(kGrid, [&](double b) { return truth.rangeAt_m(b) + random.normal(kSigma_m); });
    const LineFit fit = fitLine(rays, allOf(rays), startAt(truth));
    curvature2 += std::pow(fit.curvature_1_m / fit.curvatureSigma_1_m, 2) / kWalls;
    whiteness += fit.whiteness / kWalls;
    whiteness2 += fit.whiteness * fit.whiteness / kWalls;
  }
  EXPECT_NEAR(curvature2, 1, 0.1) << "the quadratic term is N(0, its own sigma)";
  EXPECT_NEAR(whiteness, 0, 0.15);
  EXPECT_NEAR(whiteness2, 1, 0.15);
}

//   ----------          two wall panels, the right one 2 cm closer
//             ---------
TEST(LineFit, AStepOfTwoCentimetresIsNotWhite)
{
  test::RandomNumbers random(34);
  SCOPED_TRACE(random.seedText());
  const Line far{2.02, 0, {}}, near{2, 0, {}};
  const RaySoA rays = raysOf(
      kGrid, [&](double b) { return (b < 0 ? far : near).rangeAt_m(b) + random.normal(0.005); }, 0,
      {0.005});
  EXPECT_GT(fitLine(rays, allOf(rays), {{1, 0}, 2.01}).whiteness, 2.5);
}
}  // namespace psmks
