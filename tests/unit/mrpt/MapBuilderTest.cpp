/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/Clock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>
#include <psmks/mrpt/MapBuilder.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>
#include <tests/unit/mrpt/Observation.h>

#include <algorithm>
#include <filesystem>

namespace psmks::test
{
using mrpt::config::CConfigFileMemory;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimpleMap;
using mrpt::maps::CSimplePointsMap;
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;
using mrpt::poses::CPosePDFGaussian;

namespace
{
/** The sections that icp-slam's ini files have. */
const std::string kIni =
    "[MappingApplication]\n"
    "insertionLinDistance = 0.25\n"
    "insertionAngDistance = 20\n"
    "matchAgainstTheGrid = 1\n"
    "pointsMap_count = 1\n"
    "occupancyGrid_count = 1\n"
    "[MappingApplication_pointsMap_00_insertOpts]\n"
    "minDistBetweenLaserPoints = 0.02\n"
    "addToExistingPointsMap = true\n"
    "disableDeletion = true\n"
    "[MappingApplication_occupancyGrid_00_creationOpts]\n"
    "resolution = 0.05\n";

/** A robot that drives a curve through the office; its wheels measure a tenth too much. */
class MapBuilderTest : public testing::Test
{
 protected:
  const CPose2D T_office_start_{-0.8, -0.6, degToRad(10)};
  const CPose2D trueStep_{0.10, 0, degToRad(4)}, measuredStep_{0.11, 0, degToRad(4.4)};
  const Scanner scanner_{CPose3D(0.2, 0, 0.3, 0, 0, 0), true, degToRad(270), 541};

  void SetUp() override
  {
    builder_.loadOptions(CConfigFileMemory(kIni));
    builder_.initialize();
  }

  static CPose2D repeated(const CPose2D& step, int times)
  {
    CPose2D T;
    for (int i = 0; i < times; ++i) T = T + step;
    return T;
  }

  CObservation2DRangeScan::Ptr scanAt(int i) const
  {
    auto scan = CObservation2DRangeScan::Create(
        observe(officeRoom(), T_office_start_ + repeated(trueStep_, i), scanner_));
    scan->timestamp = mrpt::Clock::fromDouble(1.6e9 + 0.5 * i);
    scan->sensorLabel = "LASER";
    return scan;
  }

  /** The step to a scan, and the scan. */
  void drive(mrpt::slam::CMetricMapBuilder& builder, int i) const
  {
    CActionCollection actions;
    CActionRobotMovement2D movement;
    movement.computeFromOdometry(i == 0 ? CPose2D() : measuredStep_, {});
    const CObservation2DRangeScan::Ptr scan = scanAt(i);
    movement.timestamp = scan->timestamp;
    actions.insert(movement);
    CSensoryFrame frame;
    frame.insert(scan);
    builder.processActionObservation(actions, frame);
  }

  void drive(int from, int to)
  {
    for (int i = from; i < to; ++i) drive(builder_, i);
  }

  Pose2 pose() const { return toPose2(CPose2D(builder_.getCurrentPoseEstimation()->getMeanVal())); }

  static const CMultiMetricMap& map(const CMultiMetricMap* maps) { return *maps; }
  static const CMultiMetricMap& map(const CMultiMetricMap& maps) { return maps; }
  CSimplePointsMap::Ptr points() const
  {
    return map(builder_.getCurrentlyBuiltMetricMap()).mapByClass<CSimplePointsMap>();
  }

  MapBuilder builder_;
};
}  // namespace

TEST_F(MapBuilderTest, LocalisesByScansAndFillsTheMaps)
{
  drive(0, 30);
  EXPECT_TRUE(isNearly(pose(), toPose2(repeated(trueStep_, 29)), 0.01, degToRad(0.3)));
  EXPECT_EQ(builder_.scans().size(), 30U);
  EXPECT_GT(builder_.getCurrentlyBuiltMapSize(), 8U);
  EXPECT_LT(builder_.getCurrentlyBuiltMapSize(), 15U);
  ASSERT_TRUE(points());
  EXPECT_GT(points()->size(), 1000U);
  const auto grid = map(builder_.getCurrentlyBuiltMetricMap()).mapByClass<COccupancyGridMap2D>();
  ASSERT_TRUE(grid);
  EXPECT_GT(grid->getPos(0.1f, 0), 0.6f);  // the robot drove there
}

TEST_F(MapBuilderTest, IsUsedThroughTheBaseClassAsThatOfIcp)
{
  const auto finalPose = [&](auto& builder)
  {
    builder.ICP_options.loadFromConfigFile(CConfigFileMemory(kIni), "MappingApplication");
    builder.setMinLoggingLevel(mrpt::system::LVL_ERROR);
    mrpt::slam::CMetricMapBuilder& base = builder;
    base.initialize();
    for (int i = 0; i < 20; ++i) drive(base, i);
    CSimpleMap built;
    base.getCurrentlyBuiltMap(built);
    EXPECT_GT(built.size(), 3U);
    return toPose2(CPose2D(base.getCurrentPoseEstimation()->getMeanVal()));
  };
  mrpt::slam::CMetricMapBuilderICP icp;
  MapBuilder psmks;
  const Pose2 truth = toPose2(repeated(trueStep_, 19));
  EXPECT_TRUE(isNearly(finalPose(icp), truth, 0.2, degToRad(5)));
  EXPECT_TRUE(isNearly(finalPose(psmks), truth, 0.01, degToRad(0.3)));
}

TEST_F(MapBuilderTest, HoldsInItsMapsWhatItsSimpleMapHolds)
{
  drive(0, 95);  // once round
  CSimpleMap built;
  builder_.getCurrentlyBuiltMap(built);
  EXPECT_EQ(built.size(), builder_.getCurrentlyBuiltMapSize());
  CMultiMetricMap again(builder_.ICP_options.mapInitializers);
  again.loadFromSimpleMap(built);
  const auto there = again.mapByClass<CSimplePointsMap>(), here = points();
  ASSERT_EQ(there->size(), here->size());
  double worst_m = 0;
  for (std::size_t i = 0; i < here->size(); ++i)
  {
    float x, y, u, v;
    here->getPoint(i, x, y);
    there->getPoint(i, u, v);
    worst_m = std::max(worst_m, static_cast<double>(std::hypot(x - u, y - v)));
  }
  EXPECT_LT(worst_m, 0.02);
}

TEST_F(MapBuilderTest, TakesObservationsOneByOne)
{
  for (int i = 0; i < 20; ++i)
  {
    const auto odometry = CObservationOdometry::Create();
    odometry->odometry = repeated(measuredStep_, i);
    odometry->timestamp = scanAt(i)->timestamp;
    builder_.processObservation(odometry);
    builder_.processObservation(scanAt(i));
  }
  EXPECT_TRUE(isNearly(pose(), toPose2(repeated(trueStep_, 19)), 0.01, degToRad(0.3)));
}

TEST_F(MapBuilderTest, BeginsWhereItIsTold)
{
  const CPose2D start(7, -3, degToRad(100));
  const CPosePDFGaussian x0(start);
  builder_.initialize({}, &x0);
  drive(0, 10);
  EXPECT_TRUE(isNearly(pose(), toPose2(start + repeated(trueStep_, 9)), 0.01, degToRad(0.3)));
}

TEST_F(MapBuilderTest, ContinuesAMap)
{
  drive(0, 20);
  CSimpleMap known;
  builder_.getCurrentlyBuiltMap(known);

  MapBuilder next;
  next.loadOptions(CConfigFileMemory(kIni));
  // The robot stands where it took the scan 20, 5 cm and 3 degrees from where it is said to be.
  const CPosePDFGaussian x0(repeated(trueStep_, 20) + CPose2D(0.04, 0.03, degToRad(3)));
  next.initialize(known, &x0);
  EXPECT_GE(next.getCurrentlyBuiltMapSize(), known.size());
  next.processObservation(scanAt(20));
  const auto found = next.getCurrentPoseEstimation()->getMeanVal();
  EXPECT_TRUE(
      isNearly(toPose2(CPose2D(found)), toPose2(repeated(trueStep_, 20)), 0.02, degToRad(0.5)));
}

TEST_F(MapBuilderTest, InsertsAsItsOptionsSay)
{
  builder_.ICP_options.insertionLinDistance = 100;
  builder_.ICP_options.insertionAngDistance = kPi;
  drive(0, 10);
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 1U) << "the first";
  builder_.options.debugForceInsertion = true;
  drive(10, 12);
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 3U);
  builder_.enableMapUpdating(false);
  drive(12, 14);
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 3U);
  EXPECT_EQ(builder_.scans().size(), 14U) << "it goes on to localise";
}

TEST_F(MapBuilderTest, LoadsOptionsOfPsmksBesideThoseOfIcp)
{
  builder_.loadOptions(CConfigFileMemory(kIni + "[ICP]\nmaxIterations = 80\n"
                                                "[PSMKS.segmentation]\nmin_rays = 9\n"));
  EXPECT_EQ(builder_.psmks_options.matching.matcher.segmentation.minRays, 9);
  EXPECT_EQ(builder_.ICP_options.insertionLinDistance, 0.25);
  EXPECT_NEAR(builder_.ICP_options.insertionAngDistance, degToRad(20), 1e-12);
  EXPECT_TRUE(builder_.ICP_options.matchAgainstTheGrid);
  EXPECT_TRUE(says(thrownText<OptionError>(
                       [&] {
                         builder_.loadOptions(
                             CConfigFileMemory(kIni + "[PSMKS.segmentation]\nmin_ray = 9\n"));
                       }),
                   {"min_ray"}));
}

TEST_F(MapBuilderTest, DrawsItsGrid)
{
  const ScratchFolder folder;
  drive(0, 3);
  builder_.saveCurrentEstimationToImage(folder.path("map.png"));
  EXPECT_GT(std::filesystem::file_size(folder.path("map.png")), 100U);
}

TEST_F(MapBuilderTest, TakesScansWithoutAReturn)
{
  drive(0, 3);
  const auto blind = scanAt(3);
  for (std::size_t ray = 0; ray < blind->getScanSize(); ++ray)
    blind->setScanRangeValidity(ray, false);
  builder_.processObservation(blind);
  EXPECT_TRUE(pose().isFinite());
}
}  // namespace psmks::test
