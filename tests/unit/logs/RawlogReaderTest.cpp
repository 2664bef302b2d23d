/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/RawlogReader.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/RoomLog.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

constexpr int kScans = 8;

std::vector<LaserFrame> readAll(RawlogReader& reader)
{
  std::vector<LaserFrame> frames;
  for (LaserFrame frame; reader.next(frame);) frames.push_back(frame);
  return frames;
}

class RawlogReaderTest : public testing::Test
{
 protected:
  std::vector<LaserFrame> framesOf(const Entries& entries)
  {
    writeGzipped(entries, path_);
    RawlogReader reader(path_);
    const auto frames = readAll(reader);
    EXPECT_EQ(reader.damage(), "");
    return frames;
  }

  /** Cuts the file to a share of its bytes and reads what remains. */
  std::string damageAfterCut(double share)
  {
    std::filesystem::resize_file(
        path_, static_cast<std::uintmax_t>(share * double(std::filesystem::file_size(path_))));
    RawlogReader reader(path_);
    framesBeforeDamage_ = readAll(reader).size();
    return reader.damage();
  }

  const RoomLog log_{kScans};
  const ScratchFolder folder_;
  const std::string path_ = folder_.path("rawlog");
  std::size_t framesBeforeDamage_ = 0;
};

TEST_F(RawlogReaderTest, BothKindsOfRawlogYieldTheSameScansStampsAndOdometry)
{
  for (const Entries& entries : {asFrames(log_), asObservations(log_)})
  {
    const auto frames = framesOf(entries);
    ASSERT_EQ(frames.size(), log_.steps.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      EXPECT_NEAR(frames[i].stamp_s, log_.steps[i].stamp_s, 1e-6);
      EXPECT_EQ(frames[i].scan->getScanSize(), log_.steps[i].scan->getScanSize());
      if (i == 0) continue;
      ASSERT_TRUE(frames[i].odometry);
      EXPECT_TRUE(isNearly(*frames[i].odometry, log_.steps[i].odometryIncrement, 1e-9, 1e-9));
    }
  }
}

TEST_F(RawlogReaderTest, IncrementsOfSeveralActionsBeforeAScanAddUp)
{
  Entries entries = asFrames(log_);
  entries.erase(entries.begin() + 3);  // the second sensory frame
  const auto frames = framesOf(entries);
  ASSERT_EQ(frames.size(), kScans - 1u);
  const Pose2 step = log_.steps[1].odometryIncrement;
  EXPECT_TRUE(isNearly(*frames[1].odometry, step * step, 1e-9, 1e-9));
}

TEST_F(RawlogReaderTest, OdometryBetweenTwoReadingsIsInterpolatedAndSoonAfterThemExtrapolated)
{
  Entries entries = asObservations(log_);
  // Scan 2 comes a quarter of a period after its odometry.
  const auto late = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(
      log_.steps[2].scan->duplicateGetSmartPtr());
  late->timestamp = mrpt::Clock::fromDouble(log_.steps[2].stamp_s + 0.0625);
  entries[5] = late;
  const auto frames = framesOf(entries);
  const Pose2 step = log_.steps[1].odometryIncrement;
  const Pose2 quarter{step.x_m / 4, step.y_m / 4, step.phi_rad / 4};
  EXPECT_TRUE(isNearly(*frames[2].odometry, step * quarter, 1e-6, 1e-6));
}

TEST_F(RawlogReaderTest, ScansWithoutOdometryHaveNone)
{
  Entries entries;
  for (const auto& step : log_.steps) entries.push_back(step.scan);
  for (const auto& frame : framesOf(entries)) EXPECT_FALSE(frame.odometry);
}

TEST_F(RawlogReaderTest, CommentsAndOtherObservationsAreCarriedAlong)
{
  Entries entries = asFrames(log_);
  auto comment = mrpt::obs::CObservationComment::Create();
  comment->text = "a comment";
  entries.insert(entries.begin(), comment);
  const auto frames = framesOf(entries);
  ASSERT_EQ(frames.size(), log_.steps.size());
  EXPECT_EQ(frames[0].observations.size(), 2u);
  EXPECT_EQ(frames[1].observations.size(), 1u);
}

TEST_F(RawlogReaderTest, AScanWithoutStampHasThatOfItsActionsOrOneMadeUp)
{
  for (const auto& step : log_.steps) step.scan->timestamp = INVALID_TIMESTAMP;
  const auto frames = framesOf(asFrames(log_));
  EXPECT_NEAR(frames[3].stamp_s, log_.steps[3].stamp_s, 1e-6);

  Entries scans;
  for (const auto& step : log_.steps) scans.push_back(step.scan);
  writePlain(scans, path_);
  RawlogReader reader(path_);
  const auto stampless = readAll(reader);
  EXPECT_EQ(reader.stampsMadeUp(), kScans);
  EXPECT_GT(stampless[1].stamp_s, stampless[0].stamp_s);
}

TEST_F(RawlogReaderTest, OfSeveralScannersTheFirstOrTheOneAskedForIsRead)
{
  log_.steps[1].scan->sensorLabel = "REAR";
  writeGzipped(asFrames(log_), path_);

  RawlogReader first(path_);
  EXPECT_EQ(readAll(first).size(), kScans - 1u);
  EXPECT_EQ(first.sensorLabel(), "FRONT");
  EXPECT_EQ(first.scansOfSensors().at("REAR"), 1);

  RawlogReader rear(path_, "REAR");
  EXPECT_EQ(readAll(rear).size(), 1u);
}

TEST_F(RawlogReaderTest, AMissingAndAnEmptyFileAreDamage)
{
  EXPECT_NE(RawlogReader(path_).damage().find("no such file"), std::string::npos);
  std::ofstream(path_).close();
  EXPECT_NE(RawlogReader(path_).damage().find("empty"), std::string::npos);
}

TEST_F(RawlogReaderTest, RandomBytesAreNoRawlog)
{
  std::ofstream(path_, std::ios::binary) << std::string(2000, '\xA7');
  RawlogReader reader(path_);
  EXPECT_TRUE(readAll(reader).empty());
  EXPECT_NE(reader.damage().find("not an MRPT rawlog"), std::string::npos);
}

TEST_F(RawlogReaderTest, ACutPlainFileYieldsTheEntriesBeforeTheCut)
{
  writePlain(asFrames(log_), path_);
  EXPECT_EQ(damageAfterCut(0.6), "read 9 entries, then: the file ends within entry 10");
  EXPECT_EQ(framesBeforeDamage_, 4u);
}

TEST_F(RawlogReaderTest, ACutGzippedFileYieldsTheEntriesBeforeTheCut)
{
  writeGzipped(asFrames(log_), path_);
  const std::string damage = damageAfterCut(0.6);
  EXPECT_NE(damage.find("then: the compressed data is cut off"), std::string::npos) << damage;
  EXPECT_GE(framesBeforeDamage_, 1u);
  EXPECT_LT(framesBeforeDamage_, log_.steps.size());
}

TEST_F(RawlogReaderTest, AGzippedFileThatLostOnlyItsLastBytesIsDamagedToo)
{
  writeGzipped(asFrames(log_), path_);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 4);
  RawlogReader reader(path_);
  EXPECT_EQ(readAll(reader).size(), log_.steps.size());
  EXPECT_NE(reader.damage(), "");
}
}  // namespace
}  // namespace psmks
