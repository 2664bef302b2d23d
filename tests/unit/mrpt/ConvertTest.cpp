/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/system/datetime.h>
#include <psmks/mrpt/Convert.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/geometry/UncertainMotion.h>
#include <tests/unit/mrpt/Observation.h>

#include <limits>

namespace psmks::test
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
/** Rays of 1 m, 2 m, 3 m, ... */
CObservation2DRangeScan countingScan(std::size_t rays, double aperture_rad)
{
  CObservation2DRangeScan observation;
  observation.aperture = static_cast<float>(aperture_rad);
  observation.resizeScanAndAssign(rays, 0, true);
  for (std::size_t i = 0; i < rays; ++i) observation.setScanRange(i, static_cast<float>(i + 1));
  return observation;
}

CPose3D upsideDown(double x_m, double y_m, double yaw_rad)
{
  return CPose3D(x_m, y_m, 0.3, yaw_rad, 0, kPi);
}

using Ranges = std::vector<double>;
}  // namespace

//      2      seen from above, rightToLeft: ray 0 looks right, ray 2 left
//      |
//  3 --o-- 1
TEST(ScanConverter, TurnsRaysCounterClockwise)
{
  CObservation2DRangeScan observation = countingScan(3, kPi);
  const Scan ccw = ScanConverter().convert(observation);
  EXPECT_EQ(ccw.range_m, Ranges({1, 2, 3}));
  EXPECT_NEAR(ccw.grid.bearing_rad(0), -kPi / 2, 1e-6);
  EXPECT_NEAR(ccw.grid.bearing_rad(2), kPi / 2, 1e-6);

  observation.rightToLeft = false;
  EXPECT_EQ(ScanConverter().convert(observation).range_m, Ranges({3, 2, 1}));

  observation.sensorPose = upsideDown(0, 0, 0);
  EXPECT_EQ(ScanConverter().convert(observation).range_m, Ranges({1, 2, 3}));

  observation.rightToLeft = true;
  EXPECT_EQ(ScanConverter().convert(observation).range_m, Ranges({3, 2, 1}));
}

TEST(ScanConverter, AgreesWithMrptsPointMap)
{
  for (const bool rightToLeft : {true, false})
    for (const CPose3D& sensorPose :
         {CPose3D(0.78, 0.1, 0.3, degToRad(30), 0, 0), upsideDown(0.78, 0.1, degToRad(30))})
    {
      CObservation2DRangeScan observation = countingScan(7, degToRad(240));
      observation.rightToLeft = rightToLeft;
      observation.sensorPose = sensorPose;
      mrpt::maps::CSimplePointsMap map;
      map.insertionOptions.minDistBetweenLaserPoints = 0;
      map.insertObservation(observation);
      ASSERT_EQ(map.size(), 7u);

      const Scan scan = ScanConverter().convert(observation);
      const SensorMounting mounting = sensorMounting(observation);
      const bool reversed = rightToLeft == mounting.upsideDown;
      for (int i = 0; i < 7; ++i)
      {
        const Eigen::Vector2d p =
            mounting.T_robot_sensor *
            (scan.range_m[static_cast<std::size_t>(i)] * scan.grid.direction(i));
        float x = 0, y = 0;
        map.getPoint(static_cast<std::size_t>(reversed ? 6 - i : i), x, y);
        EXPECT_NEAR(p.x(), x, 1e-5) << "ray " << i << ", rightToLeft " << rightToLeft;
        EXPECT_NEAR(p.y(), y, 1e-5) << "ray " << i << ", rightToLeft " << rightToLeft;
      }
    }
}

TEST(ScanConverter, DropsTheRayThatCoincidesWithTheFirst)
{
  CObservation2DRangeScan observation = countingScan(5, 2 * kPi);
  const Scan scan = ScanConverter().convert(observation);
  EXPECT_EQ(scan.range_m, Ranges({1, 2, 3, 4}));
  EXPECT_TRUE(scan.grid.closed());
  EXPECT_NEAR(scan.grid.increment_rad(), kPi / 2, 1e-6);

  observation.setScanRangeValidity(0, false);
  EXPECT_EQ(ScanConverter().convert(observation).range_m, Ranges({5, 2, 3, 4}));

  observation.rightToLeft = false;
  EXPECT_EQ(ScanConverter().convert(observation).range_m, Ranges({5, 4, 3, 2}));
}

TEST(ScanConverter, KeepsEveryRayOfDistinctBearings)
{
  const Scan all = ScanConverter().convert(countingScan(4, 2 * kPi * 3 / 4));
  EXPECT_EQ(all.range_m, Ranges({1, 2, 3, 4}));
  EXPECT_TRUE(all.grid.closed());
  EXPECT_FALSE(ScanConverter().convert(countingScan(5, degToRad(240))).grid.closed());
}

TEST(ScanConverter, KeepsWhatIsInvalidAndSaysSo)
{
  CObservation2DRangeScan observation = countingScan(4, kPi);
  observation.setScanRange(1, std::numeric_limits<float>::quiet_NaN());
  observation.setScanRangeValidity(2, false);
  observation.maxRange = 8;
  observation.timestamp = mrpt::Clock::fromDouble(1234.5);

  const Scan scan = ScanConverter().convert(observation);
  EXPECT_EQ(scan.valid, std::vector<std::uint8_t>({1, 1, 0, 1}));
  EXPECT_TRUE(std::isnan(scan.range_m[1]));
  EXPECT_EQ(scan.maxRange_m, 8);
  EXPECT_NEAR(scan.stamp_s, 1234.5, 1e-6);
}

TEST(ScanConverter, TakesATimeThatIsNotSetAsZero)
{
  CObservation2DRangeScan observation = countingScan(4, kPi);
  observation.timestamp = INVALID_TIMESTAMP;
  const Scan scan = ScanConverter().convert(observation);
  EXPECT_EQ(scan.stamp_s, 0);
  EXPECT_EQ(scan.sweepDuration_s, 0) << "unknown";
}

TEST(ScanConverter, TakesTheRangeSigmaOnlyWhereItIsStated)
{
  CObservation2DRangeScan observation = countingScan(4, kPi);
  const auto sigma_m = [&](float stdError)
  {
    observation.stdError = stdError;
    return ScanConverter().convert(observation).rangeSigma_m;
  };
  EXPECT_EQ(sigma_m(CObservation2DRangeScan().stdError), 0);
  EXPECT_FLOAT_EQ(static_cast<float>(sigma_m(0.03f)), 0.03f);
  EXPECT_EQ(sigma_m(0), 0);
  EXPECT_EQ(sigma_m(-1), 0);
  EXPECT_EQ(sigma_m(50), 0);
  EXPECT_EQ(sigma_m(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(ScanConverter, GivesNoRaysForScansWithoutBearings)
{
  EXPECT_EQ(ScanConverter().convert(CObservation2DRangeScan()).grid.count(), 0);
  EXPECT_EQ(ScanConverter().convert(countingScan(1, kPi)).grid.count(), 0);
  EXPECT_EQ(ScanConverter().convert(countingScan(5, 0)).grid.count(), 0);
  EXPECT_EQ(ScanConverter().convert(countingScan(5, -1)).grid.count(), 0);
  EXPECT_EQ(ScanConverter().convert(countingScan(5, 1e9)).grid.count(), 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ScanConverter().convert(countingScan(5, nan)).grid.count(), 0);
}

TEST(ScanConverter, SharesTheDirectionsOfOneScanner)
{
  ScanConverter converter;
  const Scan first = converter.convert(countingScan(7, kPi));
  EXPECT_EQ(converter.convert(countingScan(7, kPi)).grid.cosines(), first.grid.cosines());
  EXPECT_NE(converter.convert(countingScan(8, kPi)).grid.cosines(), first.grid.cosines());
}

TEST(SensorMounting, MeasuresTheTilt)
{
  CObservation2DRangeScan observation;
  const auto tilt_deg = [&](double pitch_deg, double roll_deg)
  {
    observation.sensorPose = CPose3D(0, 0, 0, 1, degToRad(pitch_deg), degToRad(roll_deg));
    return radToDeg(sensorMounting(observation).tilt_rad);
  };
  EXPECT_NEAR(tilt_deg(0, 0), 0, 1e-6);
  EXPECT_NEAR(tilt_deg(0, 180), 0, 1e-5);
  EXPECT_NEAR(tilt_deg(20, 0), 20, 1e-6);
  EXPECT_NEAR(tilt_deg(0, -170), 10, 1e-6);

  observation.sensorPose = CPose3D();
  observation.deltaPitch = 0.25;
  EXPECT_EQ(sensorMounting(observation).tilt_rad, 0.25);
}

TEST(Conjugated, ComposesAsMrptDoes)
{
  const UncertainPose motion = someMotion();
  const CPose2D expected = toMrpt(kRef) + toMrpt(motion.pose) - CPose2D();
  const Pose2 robot = conjugated(motion, kRef, kCur).pose;
  EXPECT_TRUE(isNearly(robot * kCur, toPose2(expected), 1e-12, 1e-12));
}

TEST(UncertainPose, ComposesAsMrptDoes)
{
  const UncertainPose a = someMotion(), b{kCur, a.covariance};
  const UncertainPose expected = toUncertainPose(toMrpt(a) + toMrpt(b));
  EXPECT_TRUE(isNearly(composed(a, b).pose, expected.pose, 1e-12, 1e-12));
  EXPECT_LT((composed(a, b).covariance - expected.covariance).norm(), 1e-15);
}

TEST(UncertainPose, IsSeenFromAnotherAsMrptSeesIt)
{
  const UncertainPose a = someMotion(), b{kCur, a.covariance};
  const UncertainPose expected = toUncertainPose(toMrpt(b) - toMrpt(a));
  EXPECT_TRUE(isNearly(seenFrom(a, b).pose, expected.pose, 1e-12, 1e-12));
  EXPECT_LT((seenFrom(a, b).covariance - expected.covariance).norm(), 1e-15);
}

TEST(UncertainPose, GoesToMrptAndBack)
{
  const UncertainPose motion = someMotion();
  const UncertainPose back = toUncertainPose(toMrpt(motion));
  EXPECT_TRUE(isNearly(back.pose, motion.pose, 1e-15, 1e-15));
  EXPECT_EQ(back.covariance, motion.covariance);
}
}  // namespace psmks::test
