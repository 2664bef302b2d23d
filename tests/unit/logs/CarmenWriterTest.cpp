/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/logs/CarmenReader.h>
#include <psmks/logs/CarmenWriter.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/logs/RawlogWriter.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/CarmenText.h>

#include <cstdlib>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

/** The error of a bearing by a float aperture. */
constexpr double kBearingTolerance_rad = 1e-7;

std::vector<LaserFrame> framesOf(LogReader& reader)
{
  std::vector<LaserFrame> frames;
  for (LaserFrame frame; reader.next(frame);) frames.push_back(frame);
  EXPECT_EQ(reader.damage(), "");
  return frames;
}

double firstBearing_rad(const LaserFrame& frame)
{
  return wrapAngle(sensorMounting(*frame.scan).T_robot_sensor.phi_rad +
                   ScanConverter().convert(*frame.scan).grid.firstBearing_rad());
}

void expectSameScan(const LaserFrame& a, const LaserFrame& b)
{
  const Scan one = ScanConverter().convert(*a.scan), other = ScanConverter().convert(*b.scan);
  ASSERT_EQ(one.grid.count(), other.grid.count());
  EXPECT_NEAR(one.grid.increment_rad() * one.grid.count(),
              other.grid.increment_rad() * other.grid.count(), kBearingTolerance_rad);
  EXPECT_NEAR(wrapAngle(firstBearing_rad(a) - firstBearing_rad(b)), 0, kBearingTolerance_rad);
  const auto placeOf = [](const LaserFrame& frame)
  { return sensorMounting(*frame.scan).T_robot_sensor.translation(); };
  EXPECT_LT((placeOf(a) - placeOf(b)).norm(), 1e-9);
  EXPECT_EQ(one.valid, other.valid);
  for (std::size_t ray = 0; ray < one.range_m.size(); ++ray)
  {
    if (!one.valid[ray]) continue;
    EXPECT_EQ(one.range_m[ray], other.range_m[ray]);
  }
}

void expectSameLog(const std::vector<LaserFrame>& a, const std::vector<LaserFrame>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    SCOPED_TRACE("scan " + std::to_string(i));
    EXPECT_NEAR(a[i].stamp_s, b[i].stamp_s, 1e-6);
    if (i > 0 && a[i].odometry)
    {
      ASSERT_TRUE(b[i].odometry);
      EXPECT_TRUE(isNearly(*b[i].odometry, *a[i].odometry, 1e-6, 1e-6));
    }
    expectSameScan(a[i], b[i]);
  }
}

class CarmenWriterTest : public testing::Test
{
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  std::string rawlogOf(const std::vector<LaserFrame>& frames, RawlogFormat format) const
  {
    RawlogWriter::Options options;
    options.format = format;
    RawlogWriter writer(options);
    EXPECT_TRUE(writer.open(path("a.rawlog")));
    for (const auto& frame : frames) writer.write(frame);
    return path("a.rawlog");
  }

  std::string carmenLogOf(const std::vector<LaserFrame>& frames, const std::string& name) const
  {
    CarmenWriter writer;
    EXPECT_TRUE(writer.open(path(name)));
    for (const auto& frame : frames) EXPECT_TRUE(writer.write(frame));
    EXPECT_TRUE(writer.close());
    return path(name);
  }

  /** Converts a CARMEN log to a rawlog and back, and expects the same text. */
  void expectRoundTrip(const std::string& log) const
  {
    CarmenReader original(log);
    const auto frames = framesOf(original);
    ASSERT_FALSE(frames.empty());
    for (const RawlogFormat format : {RawlogFormat::Actions, RawlogFormat::Observations})
    {
      RawlogReader rawlog(rawlogOf(frames, format));
      const auto converted = framesOf(rawlog);
      EXPECT_EQ(rawlog.sensorLabel(), original.sensorLabel());
      expectSameLog(frames, converted);
      CarmenReader back(carmenLogOf(converted, "back.log.gz"));
      expectSameLog(frames, framesOf(back));
      EXPECT_EQ(back.sensorLabel(), original.sensorLabel());
    }
  }

  std::string written(const std::string& text) const
  {
    std::ofstream(path("original.log")) << text;
    return path("original.log");
  }

  const ScratchFolder folder_;
};

/** Ranges that a float cannot represent exactly, with a missing return among them. */
std::vector<double> unevenRanges(int rays)
{
  std::vector<double> ranges_m;
  for (int ray = 0; ray < rays; ++ray) ranges_m.push_back(ray % 7 == 3 ? 81.91 : 1 + 0.01 * ray);
  return ranges_m;
}

TEST_F(CarmenWriterTest, FlasersOfAllUsualKindsComeBack)
{
  for (const int rays : {180, 181, 360, 361, 401})
  {
    SCOPED_TRACE(std::to_string(rays) + " rays");
    const auto ranges_m = unevenRanges(rays);
    expectRoundTrip(written((rays == 401 ? "PARAM laser_front_laser_resolution 0.25 0 h 0\n" : "") +
                            std::string("PARAM robot_frontlaser_offset 0.31 0 h 0\n") +
                            flaser(ranges_m, {1, 2, 3}, 1134864629.895182) +
                            flaser(ranges_m, {1.1, 2.2, -3.1}, 1134864630.104217)));
  }
}

TEST_F(CarmenWriterTest, ARobotLaserOnTheSideComesBack)
{
  const std::string scanner = "ROBOTLASER1 99 -2.0943951 4.1887902 0.0104719755 5.6 0.01 0";
  std::string text;
  for (const double stamp_s : {10.25, 10.5})
    text += scanner + carmenRanges(std::vector<double>(401, 1.5)) + " 0" +
            carmenPose(Pose2{stamp_s, 2, 0.3} * Pose2{0.1, -0.2, -0.5}) +
            carmenPose({stamp_s, 2, 0.3}) + " 0 0 0 0 0" + carmenStamps(stamp_s, 0);
  expectRoundTrip(written(text));
}

TEST_F(CarmenWriterTest, StampsThatGoBackComeBack)
{
  std::string text;
  for (const double stamp_s : {5.0, 6.0, 6.0, 5.5, 5.0, 7.0})
    text += flaser(unevenRanges(181), {stamp_s, 0, 0}, stamp_s);
  expectRoundTrip(written(text));
}

TEST_F(CarmenWriterTest, ALogWithoutStampsGetsThoseThatWereMadeUp)
{
  expectRoundTrip(
      written(flaser(unevenRanges(181), {}, 0) + flaser(unevenRanges(181), {1, 0, 0}, 0)));
}

TEST_F(CarmenWriterTest, TheRayThatClosesTheCircleIsDropped)
{
  LaserFrame frame;
  frame.scan = mrpt::obs::CObservation2DRangeScan::Create();
  frame.scan->aperture = static_cast<float>(2 * kPi);
  frame.scan->resizeScanAndAssign(361, 2.f, true);
  frame.stamp_s = 1;
  CarmenReader reader(carmenLogOf({frame}, "round.log"));
  const auto frames = framesOf(reader);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].scan->getScanSize(), 360u);
  EXPECT_NEAR(std::abs(firstBearing_rad(frames[0])), kPi, 1e-6);
}

TEST_F(CarmenWriterTest, AScannerThatChangesIsRefused)
{
  std::ofstream(path("original.log"))
      << flaser(unevenRanges(181), {}, 1) << flaser(unevenRanges(361), {}, 2);
  CarmenReader reader(path("original.log"));
  const auto frames = framesOf(reader);
  CarmenWriter writer;
  ASSERT_TRUE(writer.open(path("a.log")));
  EXPECT_TRUE(writer.write(frames[0]));
  EXPECT_THROW(writer.write(frames[1]), std::runtime_error);
}

TEST_F(CarmenWriterTest, AFileThatCannotBeCreatedIsTold)
{
  EXPECT_FALSE(CarmenWriter().open(path("no/folder/a.log")));
}

TEST_F(CarmenWriterTest, ARealLogComesBack)
{
  const char* folder = std::getenv("PSMKS_DATA_DIR");
  if (!folder) GTEST_SKIP() << "PSMKS_DATA_DIR is not set";
  expectRoundTrip(std::string(folder) + "/csail.log.gz");
}
}  // namespace
}  // namespace psmks
