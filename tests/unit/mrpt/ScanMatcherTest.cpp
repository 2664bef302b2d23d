/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/stock_observations.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <psmks/mrpt/ScanMatcher.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Says.h>
#include <tests/support/ThrownText.h>
#include <tests/unit/mrpt/Observation.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <thread>

namespace psmks::test
{
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;
using mrpt::poses::CPose3DPDFGaussian;
using mrpt::poses::CPosePDF;
using mrpt::poses::CPosePDFGaussian;
using mrpt::slam::CICP;
using ReturnInfo = ScanMatcher::ReturnInfo;

namespace
{
CObservation2DRangeScan stockScan(int i)
{
  CObservation2DRangeScan scan;
  mrpt::obs::stock_observations::example2DRangeScan(scan, i);
  return scan;
}

/** As MRPT's own test of its ICP makes it: default insertion options. */
CSimplePointsMap stockMap(int i)
{
  CSimplePointsMap map;
  const CObservation2DRangeScan scan = stockScan(i);
  map.insertObservation(scan);
  return map;
}

/** MRPT's reference solution of its ICP test, and the initial guess of that test. */
const Pose2 kStockMotion{0.820, 0.084, degToRad(8.73)};
const CPose2D kStockGuess(0.8, 0, 0);

CPosePDFGaussian withoutPrior(const CPose2D& pose) { return CPosePDFGaussian(pose); }

CPosePDFGaussian withPrior(const CPose2D& pose, double sigma_m, double sigma_rad)
{
  CPosePDFGaussian pdf(pose);
  pdf.cov(0, 0) = pdf.cov(1, 1) = sigma_m * sigma_m;
  pdf.cov(2, 2) = sigma_rad * sigma_rad;
  return pdf;
}

const CPosePDFGaussian& gaussian(const CPosePDF::Ptr& pdf)
{
  return dynamic_cast<const CPosePDFGaussian&>(*pdf);
}

bool isPositiveDefinite(const CPosePDFGaussian& pdf)
{
  return pdf.cov.asEigen().llt().info() == Eigen::Success;
}

/** Warnings of matches that are meant to fail are not printed. */
ScanMatcher silentMatcher()
{
  ScanMatcher matcher;
  matcher.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  return matcher;
}
}  // namespace

TEST(ScanMatcher, PassesMrptsIcpTestWithScans)
{
  ScanMatcher matcher;
  ReturnInfo info;
  const auto pose = matcher.align(stockScan(0), stockScan(1), withoutPrior(kStockGuess), &info);
  EXPECT_TRUE(isNearly(toPose2(pose->mean), kStockMotion, 0.02, degToRad(0.5)))
      << info.match.report();
  EXPECT_GT(info.goodness, 0.4);
  EXPECT_TRUE(isPositiveDefinite(*pose));
}

TEST(ScanMatcher, PassesMrptsIcpTestWithPointMaps)
{
  ScanMatcher matcher;
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  ReturnInfo info;
  const CPosePDF::Ptr pose = matcher.Align(&m1, &m2, kStockGuess, info);
  EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), kStockMotion, 0.02, degToRad(0.5)))
      << info.match.report();
  EXPECT_GT(info.goodness, 0.4);
}

TEST(ScanMatcher, MatchesAPointMapWithAGrid)
{
  ScanMatcher matcher;
  COccupancyGridMap2D m1(-10, 10, -10, 10, 0.05f);
  const CObservation2DRangeScan scan = stockScan(0);
  m1.insertObservation(scan);
  const CSimplePointsMap m2 = stockMap(1);
  ReturnInfo info;
  const CPosePDF::Ptr pose = matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess), info);
  EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), kStockMotion, 0.03, degToRad(0.7)))
      << info.match.report();
}

//  As MRPT's icp-slam fills its grid: one hit leaves a cell free with 46 %. MRPT 2.5.8 inserts the
//  rays of a scan turned by up to half a degree into grids, hence the wide limit of the heading.
TEST(ScanMatcher, MatchesGridsOfTheCertaintyOfStockIniFiles)
{
  ScanMatcher matcher;
  COccupancyGridMap2D m1(-10, 10, -10, 10, 0.05f), grid2(-10, 10, -10, 10, 0.05f);
  for (auto* grid : {&m1, &grid2}) grid->insertionOptions.maxOccupancyUpdateCertainty = 0.54f;
  const CObservation2DRangeScan scan1 = stockScan(0), scan2 = stockScan(1);
  m1.insertObservation(scan1);
  grid2.insertObservation(scan2);
  const CSimplePointsMap points2 = stockMap(1);
  const Pose2 ofScans = toPose2(matcher.align(scan1, scan2, withoutPrior(kStockGuess))->mean);
  for (const mrpt::maps::CMetricMap* m2 :
       std::initializer_list<const mrpt::maps::CMetricMap*>{&grid2, &points2})
  {
    ReturnInfo info;
    const CPosePDF::Ptr pose = matcher.AlignPDF(&m1, m2, withoutPrior(kStockGuess), info);
    EXPECT_GT(info.goodness, 0.4);
    EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), ofScans, 0.008, degToRad(0.5)))
        << info.match.report();
  }
}

//   A map of scans from several places, whose walls small errors have doubled: seen from one place
//   its surfaces hide each other, and a scan explains only part of them.
TEST(ScanMatcher, MatchesAMapOfManyScans)
{
  const std::vector<Wall> room = officeRoom();
  CSimplePointsMap m1, m2;
  m1.insertionOptions.addToExistingPointsMap = true;
  m1.insertionOptions.disableDeletion = true;
  const Scanner scanner{CPose3D(0.78, 0, 0, 0, 0, 0), true, kPi, 361};
  const CPose2D places[] = {{-0.5, -0.3, 0.3}, {0.4, 0.3, 2}, {0.2, -0.6, -2}, {-0.8, 0.5, -1}};
  double error_m = 0.02;
  for (const CPose2D& place : places)
  {
    const auto scan = observe(room, place, scanner);
    m1.insertObservation(scan, CPose3D(place + CPose2D(error_m, -error_m, 0)));
    error_m = -error_m;
  }
  const CPose2D T_world_cur(0.1, 0.1, 0.9);
  m2.insertObservation(observe(room, T_world_cur, scanner));
  ScanMatcher matcher;
  ReturnInfo info;
  const auto pose = matcher.AlignPDF(&m1, &m2, withoutPrior({0.0, 0.2, 1.0}), info);
  EXPECT_GT(info.goodness, 0.4) << info.match.report();
  EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), toPose2(T_world_cur), 0.03, degToRad(0.5)))
      << info.match.report();
}

TEST(ScanMatcher, CompilesInCodeThatWasWrittenForIcp)
{
  const auto alignTest = [](auto icp)
  {
    using Icp = decltype(icp);
    typename Icp::TConfigParams params = icp.options;
    params.ICP_algorithm = mrpt::slam::icpLevenbergMarquardt;
    params.maxIterations = 100;
    params.thresholdAng = degToRad(10);
    params.thresholdDist = 0.75;
    params.ALFA = 0.5;
    params.smallestThresholdDist = 0.05;
    params.corresponding_points_decimation = 1;
    params.skip_cov_calculation = false;
    params.doRANSAC = false;
    Icp other(params);
    typename Icp::TReturnInfo info;
    const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
    const CPosePDF::Ptr pose = other.Align(&m1, &m2, kStockGuess, info);
    EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), kStockMotion, 0.02, degToRad(0.5)));
    EXPECT_GT(info.goodness, 0.4);
    EXPECT_GT(info.nIterations, 0U);
  };
  alignTest(CICP());
  alignTest(ScanMatcher());
}

TEST(ScanMatcher, ServesThreadsThatShareIt)
{
  constexpr int kThreads = 4, kTimes = 5;
  ScanMatcher matcher;
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  const CObservation2DRangeScan scan1 = stockScan(0), scan2 = stockScan(1);
  const auto ofMaps = matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess))->getMeanVal();
  const auto ofScans = matcher.align(scan1, scan2, withoutPrior(kStockGuess))->mean;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back(
        [&]
        {
          for (int i = 0; i < kTimes; ++i)
          {
            EXPECT_EQ(matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess))->getMeanVal(), ofMaps);
            EXPECT_EQ(matcher.align(scan1, scan2, withoutPrior(kStockGuess))->mean, ofScans);
          }
        });
  for (std::thread& thread : threads) thread.join();
}

TEST(ScanMatcher, FillsTheReturnInfoOfIcp)
{
  ScanMatcher matcher;
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  ReturnInfo own;
  CICP::TReturnInfo icp;
  mrpt::slam::TMetricMapAlignmentResult base;
  matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess), own);
  matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess), icp);
  matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess), base);

  EXPECT_EQ(icp.goodness, own.goodness);
  EXPECT_EQ(icp.quality, own.quality);
  EXPECT_EQ(icp.nIterations, own.nIterations);
  EXPECT_EQ(icp.nIterations, static_cast<unsigned>(own.match.iterations));
  EXPECT_GT(icp.goodness, 0.4);
  EXPECT_GT(icp.executionTime, 0);
  EXPECT_GT(base.executionTime, 0);
}

//  Mountings: forward and offset, turned, upside-down, scanning clockwise; the same robot motion
//  comes out of every one of them.
TEST(ScanMatcher, GivesTheMotionOfTheRobotForEveryMounting)
{
  const std::vector<Wall> room = officeRoom();
  const CPose2D T_world_ref(-0.5, -0.3, degToRad(20)), T_ref_cur(0.25, 0.10, degToRad(12));
  const CPose2D T_world_cur = T_world_ref + T_ref_cur;
  const CPose3D mountings[] = {CPose3D(), CPose3D(0.78, 0.1, 0.3, degToRad(30), 0, 0),
                               CPose3D(0.78, 0.1, 0.3, degToRad(30), 0, kPi),
                               CPose3D(-0.2, 0.3, 0.3, degToRad(-120), kPi, 0)};
  for (const CPose3D& mounting : mountings)
    for (const bool rightToLeft : {true, false})
      for (const double aperture_rad : {degToRad(240), 2 * kPi})
      {
        const Scanner scanner{mounting, rightToLeft, aperture_rad, 481};
        ScanMatcher matcher;
        ReturnInfo info;
        const auto pose =
            matcher.align(observe(room, T_world_ref, scanner), observe(room, T_world_cur, scanner),
                          withoutPrior({0.2, 0.05, degToRad(8)}), &info);
        EXPECT_TRUE(isNearly(toPose2(pose->mean), toPose2(T_ref_cur), 1e-3, degToRad(0.02)))
            << mounting << ", rightToLeft " << rightToLeft << ": " << info.match.report();
      }
}

TEST(ScanMatcher, MatchesScansOfTwoSensors)
{
  const std::vector<Wall> room = officeRoom();
  const CPose2D T_world_ref(-0.5, -0.3, degToRad(20)), T_ref_cur(0.25, 0.10, degToRad(12));
  const Scanner front{CPose3D(0.4, 0, 0, 0, 0, 0), true, degToRad(270), 541};
  const Scanner rear{CPose3D(-0.3, 0, 0, degToRad(20), 0, kPi), true, degToRad(270), 361};
  ScanMatcher matcher;
  const auto pose =
      matcher.align(observe(room, T_world_ref, front), observe(room, T_world_ref + T_ref_cur, rear),
                    withoutPrior({0.2, 0.05, degToRad(8)}));
  EXPECT_TRUE(isNearly(toPose2(pose->mean), toPose2(T_ref_cur), 1e-3, degToRad(0.02)));
}

TEST(ScanMatcher, LooksAtMapsFromThePlaceOfTheScanner)
{
  const std::vector<Wall> room = officeRoom();
  const CPose2D T_world_ref(-0.5, -0.3, degToRad(20)), T_ref_cur(0.25, 0.10, degToRad(12));
  const Scanner scanner{CPose3D(0.78, 0.1, 0, degToRad(30), 0, 0), true, degToRad(240), 481};
  CSimplePointsMap m1, m2;
  m1.insertObservation(observe(room, T_world_ref, scanner));
  m2.insertObservation(observe(room, T_world_ref + T_ref_cur, scanner));

  ScanMatcher matcher;
  matcher.options.view.T_map_sensor = {0.78, 0.1, degToRad(30)};
  matcher.options.view.fieldOfView_rad = degToRad(240);
  matcher.options.view.rays = 481;
  const CPosePDF::Ptr pose = matcher.AlignPDF(&m1, &m2, withoutPrior({0.2, 0.05, degToRad(8)}));
  EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), toPose2(T_ref_cur), 5e-3, degToRad(0.1)));
}

//  Two bare walls: only a prior fixes the place along them.
//
//  =======================
//      o ->
//  =======================
TEST(ScanMatcher, KeepsTheGuessAlongACorridorAndSaysSo)
{
  const Scanner scanner{CPose3D(0.3, 0, 0, degToRad(90), 0, 0), true, degToRad(240), 481, 10};
  ScanMatcher matcher;
  ReturnInfo info;
  const auto pose = matcher.align(observe(corridor(), {0, 0, 0}, scanner),
                                  observe(corridor(), {0.5, 0.05, 0}, scanner),
                                  withPrior({0.45, 0, 0}, 0.1, degToRad(3)), &info);
  EXPECT_TRUE(isNearly(toPose2(pose->mean), {0.45, 0.05, 0}, 0.005, degToRad(0.1)));
  EXPECT_EQ(info.quality, 0);
  EXPECT_GT(info.goodness, 0.4);
  EXPECT_GT(std::sqrt(pose->cov(0, 0)), 0.05);
  EXPECT_LT(std::sqrt(pose->cov(1, 1)), 0.02);
}

TEST(ScanMatcher, KeepsTheGuessWhenAMapIsEmpty)
{
  ScanMatcher matcher = silentMatcher();
  const CSimplePointsMap full = stockMap(0), empty;
  const COccupancyGridMap2D emptyGrid;
  const std::pair<const mrpt::maps::CMetricMap*, const mrpt::maps::CMetricMap*> pairs[] = {
      {&full, &empty}, {&empty, &full}, {&empty, &empty}, {&emptyGrid, &full}};
  for (const auto& [m1, m2] : pairs)
  {
    ReturnInfo info;
    const auto pose = matcher.AlignPDF(m1, m2, withoutPrior(kStockGuess), info);
    EXPECT_EQ(info.match.status, MatchStatus::InvalidInput);
    EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), toPose2(kStockGuess), 1e-12, 1e-12));
    EXPECT_EQ(info.goodness, 0);
    // Particle filters draw from it, whether the alignment failed or not.
    EXPECT_DOUBLE_EQ(gaussian(pose).cov(0, 0), std::pow(matcher.options.guessSigma_m, 2));
    EXPECT_DOUBLE_EQ(gaussian(pose).cov(2, 2), std::pow(matcher.options.guessSigma_rad, 2));
    EXPECT_TRUE(isPositiveDefinite(gaussian(pose)));
  }
}

TEST(ScanMatcher, KeepsTheGuessWhenMapsHaveNothingInCommon)
{
  ScanMatcher matcher = silentMatcher();
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  const CPose2D farAway(500, -300, 1);
  ReturnInfo info;
  const auto pose = matcher.AlignPDF(&m1, &m2, withPrior(farAway, 0.2, degToRad(5)), info);
  EXPECT_FALSE(info.match.usable());
  EXPECT_TRUE(isNearly(toPose2(pose->getMeanVal()), toPose2(farAway), 1e-9, 1e-9));
  EXPECT_EQ(info.goodness, 0);
  EXPECT_EQ(info.quality, 0);
  EXPECT_NEAR(gaussian(pose).cov(0, 0), 0.04, 1e-9);  // of the guess
}

TEST(ScanMatcher, DoesNotThrowForBadScans)
{
  ScanMatcher matcher = silentMatcher();
  const CObservation2DRangeScan good = stockScan(0);
  CObservation2DRangeScan allInvalid = good, notFinite = good, tilted = good;
  for (std::size_t i = 0; i < good.getScanSize(); ++i)
  {
    allInvalid.setScanRangeValidity(i, false);
    notFinite.setScanRange(i, std::numeric_limits<float>::quiet_NaN());
  }
  tilted.sensorPose = CPose3D(0, 0, 0, 0, degToRad(20), 0);
  for (const auto& bad : {CObservation2DRangeScan(), allInvalid, notFinite, tilted})
    for (const bool badReference : {true, false})
    {
      ReturnInfo info;
      const auto pose = matcher.align(badReference ? bad : good, badReference ? good : bad,
                                      withoutPrior(kStockGuess), &info);
      EXPECT_EQ(info.match.status, MatchStatus::InvalidInput);
      EXPECT_EQ(info.goodness, 0);
      EXPECT_TRUE(isPositiveDefinite(*pose));
    }
}

TEST(ScanMatcher, WarnsAboutATiltedScan)
{
  ScanMatcher matcher;
  std::string log;
  matcher.logging_enable_console_output = false;
  matcher.logRegisterCallback([&](std::string_view message, const auto&, const auto&, auto)
                              { log += message; });
  CObservation2DRangeScan tilted = stockScan(0);
  tilted.sensorLabel = "FRONT";
  tilted.sensorPose = CPose3D(0, 0, 0, 0, degToRad(20), 0);
  matcher.align(tilted, stockScan(1), withoutPrior(kStockGuess));
  EXPECT_TRUE(says(log, {"FRONT", "20", "max_tilt_deg", "InvalidInput"}));

  log.clear();
  matcher.options.maxTilt_rad = degToRad(25);
  matcher.align(tilted, stockScan(1), withoutPrior(kStockGuess));
  EXPECT_EQ(log.find("max_tilt_deg"), std::string::npos);
}

TEST(ScanMatcher, RefusesNullMaps)
{
  ScanMatcher matcher;
  const CSimplePointsMap map;
  EXPECT_TRUE(says(thrownText<std::invalid_argument>([&] { matcher.Align(nullptr, &map, {}); }),
                   {"m1", "null"}));
  EXPECT_TRUE(says(thrownText<std::invalid_argument>([&] { matcher.Align(&map, nullptr, {}); }),
                   {"m2", "null"}));
}

TEST(ScanMatcher, LiftsPlanarProblemsTo3D)
{
  ScanMatcher matcher;
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  CICP::TReturnInfo info;
  const CPose3DPDFGaussian guess(CPose3D(0.8, 0, 0.25, 0, degToRad(1), 0));
  const auto pdf = matcher.Align3DPDF(&m1, &m2, guess, info);
  const auto& pose = dynamic_cast<const CPose3DPDFGaussian&>(*pdf);

  EXPECT_TRUE(isNearly(toPose2(CPose2D(pose.mean)), kStockMotion, 0.02, degToRad(0.5)));
  EXPECT_EQ(pose.mean.z(), 0.25);
  EXPECT_NEAR(pose.mean.pitch(), degToRad(1), 1e-12);
  EXPECT_GT(info.goodness, 0.4);
  EXPECT_EQ(pose.cov.asEigen().llt().info(), Eigen::Success);
  const auto plane = gaussian(matcher.AlignPDF(&m1, &m2, withoutPrior(kStockGuess)));
  EXPECT_EQ(pose.cov(0, 3), plane.cov(0, 2));
  EXPECT_EQ(pose.cov(3, 3), plane.cov(2, 2));
}

TEST(ScanMatcher, KeepsTheVariancesOutOfThePlaneButNotBelowThatOfAPlane)
{
  constexpr int kZ = 2, kPitch = 4, kRoll = 5;
  ScanMatcher matcher;
  const CSimplePointsMap m1 = stockMap(0), m2 = stockMap(1);
  CPose3DPDFGaussian guess(CPose3D(0.8, 0, 0, 0, 0, 0));
  guess.cov(kZ, kZ) = 0.25;
  guess.cov(kRoll, kRoll) = 0.01;
  const auto pdf = matcher.Align3DPDF(&m1, &m2, guess);
  const auto& pose = dynamic_cast<const CPose3DPDFGaussian&>(*pdf);
  EXPECT_EQ(pose.cov(kZ, kZ), 0.25);
  EXPECT_EQ(pose.cov(kRoll, kRoll), 0.01);
  EXPECT_DOUBLE_EQ(pose.cov(kPitch, kPitch), std::pow(degToRad(1), 2)) << "was 0";
}

TEST(ScanMatcher, RefusesProblemsOutOfThePlane)
{
  ScanMatcher matcher;
  const CSimplePointsMap map = stockMap(0);
  const auto text = thrownText<std::invalid_argument>(
      [&] { matcher.Align3D(&map, &map, CPose3D(0, 0, 0, 0, 0, degToRad(30))); });
  EXPECT_TRUE(says(text, {"plane", "30", "max_tilt_deg", "5"}));
}

TEST(ScanMatcher, ObeysItsOptions)
{
  ScanMatcher matcher = silentMatcher();
  matcher.options.matcher.joint.acceptScore = 1;  // of scans of the real world
  ReturnInfo info;
  matcher.align(stockScan(0), stockScan(1), withoutPrior(kStockGuess), &info);
  EXPECT_EQ(info.match.status, MatchStatus::NoImprovement);
}

TEST(ScanMatcher, TakesCeresWhereItIsBuilt)
{
  ScanMatcher own, ceres;
  ceres.options.matcher.joint.solver = JointSolver::Ceres;
  const auto expected = own.align(stockScan(0), stockScan(1), withoutPrior(kStockGuess));
  CPosePDFGaussian::Ptr pose;
  const std::string refusal = thrownText<OptionError>(
      [&] { pose = ceres.align(stockScan(0), stockScan(1), withoutPrior(kStockGuess)); });
  if (!pose)
  {
    EXPECT_TRUE(says(refusal, {"solver", "ceres"}));
    GTEST_SKIP() << "built without Ceres";
  }
  EXPECT_TRUE(isNearly(toPose2(pose->mean), toPose2(expected->mean), 1e-4, degToRad(1e-3)));
}

TEST(ScanMatcher, IsCopiedWithItsOptions)
{
  ScanMatcher matcher;
  matcher.options.view.rays = 123;
  const auto copy = std::dynamic_pointer_cast<ScanMatcher>(matcher.duplicateGetSmartPtr());
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->options.view.rays, 123);
  matcher.options.view.rays = 5;
  EXPECT_EQ(copy->options.view.rays, 123);
  const auto pose = copy->align(stockScan(0), stockScan(1), withoutPrior(kStockGuess));
  EXPECT_TRUE(isNearly(toPose2(pose->mean), kStockMotion, 0.02, degToRad(0.5)));
}
}  // namespace psmks::test
