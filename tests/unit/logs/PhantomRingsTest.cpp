/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/PhantomRings.h>
#include <psmks/logs/QuietReader.h>
#include <psmks/logs/RawlogWriter.h>
#include <tests/support/Scenes.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/RoomLog.h>

#include <functional>
#include <random>

namespace psmks
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;

/** What a reading is where nothing returns. */
using NoReturn = std::function<double()>;

/** Scans of a scanner that drives through a hall of 40 x 30 m and sees 16 m, 361 rays over 180
 * degrees. */
class PhantomRingsTest : public testing::Test
{
 protected:
  static constexpr double kMaxRange_m = 16;

  std::vector<CObservation2DRangeScan::Ptr> drive(int scans, const NoReturn& noReturn,
                                                  double step_m = 0.1)
  {
    std::vector<CObservation2DRangeScan::Ptr> observations;
    for (int i = 0; i < scans; ++i)
    {
      Scan scan = castScan(box({10, 0}, 40, 30), {i * step_m, 0.3 * i * step_m, degToRad(20)},
                           BeamGrid::centered(kPi, 361), 100, 0.01, rng_);
      for (double& range_m : scan.range_m)
        if (range_m > 15) range_m = noReturn();
      scan.maxRange_m = kMaxRange_m;
      scan.stamp_s = 0.1 * i;
      observations.push_back(toMrpt(scan, {}));
    }
    return observations;
  }

  static std::vector<RangeBand> bandsOf(const std::vector<CObservation2DRangeScan::Ptr>& scans)
  {
    PhantomRings rings;
    for (const auto& scan : scans) rings.add(*scan);
    return rings.bands();
  }

  std::mt19937 rng_{2};
};
}  // namespace

// A round room of 3 m about a scanner that stands: there is no other reading to tell it from a
// ring.
TEST_F(PhantomRingsTest, AllThatIsSeenIsNone)
{
  Scan round;
  round.grid = BeamGrid::centered(kPi, 181);
  for (int ray = 0; ray < 181; ++ray) round.range_m.push_back(3.005 + 0.01 * (ray % 5));
  round.maxRange_m = kMaxRange_m;
  EXPECT_TRUE(bandsOf(std::vector(40, toMrpt(round, {}))).empty());
}

TEST_F(PhantomRingsTest, AValueBelowTheGreatestRangeIsOne)
{
  const auto bands = bandsOf(drive(100, [] { return 15.96; }));
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_TRUE(bands[0].contains(15.96));
  EXPECT_LT(bands[0].to_m - bands[0].from_m, 0.03);
  EXPECT_GT(bands[0].readings, 100 * 50);
}

TEST_F(PhantomRingsTest, SeveralValuesAndScatteredOnesAreSome)
{
  std::uniform_real_distribution<double> scattered(8.0, 8.1);
  int turn = 0;
  const auto bands = bandsOf(drive(100, [&] { return ++turn % 2 == 0 ? 12.5 : scattered(rng_); }));
  const auto isFound = [&](double range_m)
  {
    for (const RangeBand& band : bands)
      if (band.contains(range_m)) return true;
    return false;
  };
  EXPECT_TRUE(isFound(12.5));
  EXPECT_TRUE(isFound(8.05));
  EXPECT_FALSE(isFound(10));
}

TEST_F(PhantomRingsTest, WhatTheScanFlagsIsNone)
{
  EXPECT_TRUE(bandsOf(drive(100, [] { return 16.0; })).empty()) << "at the greatest range";
}

//     ------------------------------      a robot that follows a corridor sees its walls at the
//     same
//      >  .  .  .                         distance all the time
//     ------------------------------
TEST_F(PhantomRingsTest, AWallThatIsFollowedIsNone)
{
  std::vector<CObservation2DRangeScan::Ptr> scans;
  for (int i = 0; i < 200; ++i)
    scans.push_back(toMrpt(castScan(corridor(), {0.1 * i - 10, 0.2, 0},
                                    BeamGrid::centered(2 * kPi, 720), 30, 0.005, rng_),
                           {}));
  EXPECT_TRUE(bandsOf(scans).empty());
}

TEST_F(PhantomRingsTest, TheWallsAboutAScannerThatStandsAreNone)
{
  std::vector<CObservation2DRangeScan::Ptr> scans;
  for (int i = 0; i < 200; ++i)
    scans.push_back(
        toMrpt(castScan(squareRoom(), {}, BeamGrid::centered(2 * kPi, 360), 30, 0.01, rng_), {}));
  EXPECT_TRUE(bandsOf(scans).empty());
}

TEST_F(PhantomRingsTest, AFewScansProveNothing)
{
  EXPECT_TRUE(bandsOf(drive(19, [] { return 15.96; })).empty());
  EXPECT_TRUE(bandsOf({}).empty());
}

TEST_F(PhantomRingsTest, ALogIsReadWithoutThemAndSaysSo)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path("ring.rawlog");
  {
    RawlogWriter writer(RawlogWriter::Options{RawlogFormat::Actions, {}, {}});
    ASSERT_TRUE(writer.open(path));
    for (const auto& scan : drive(60, [] { return 15.96; }))
    {
      LaserFrame frame;
      frame.scan = scan;
      frame.observations.insert(scan);
      writer.write(frame);
    }
  }
  const auto log = openLog(path);
  LaserFrame frame;
  int left = 0, valid = 0;
  while (log->next(frame))
    for (std::size_t ray = 0; ray < frame.scan->getScanSize(); ++ray)
    {
      if (!frame.scan->getScanRangeValidity(ray)) continue;
      ++valid;
      left += frame.scan->getScanRange(ray) > 15.9 ? 1 : 0;
    }
  EXPECT_EQ(left, 0);
  EXPECT_GT(valid, 60 * 50);
  ASSERT_EQ(log->remarks().size(), 1U);
  EXPECT_NE(log->remarks()[0].find("for no return"), std::string::npos) << log->remarks()[0];
}
}  // namespace psmks
