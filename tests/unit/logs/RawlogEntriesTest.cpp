/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <psmks/logs/RawlogDecoding.h>
#include <psmks/logs/RawlogEntries.h>
#include <sys/wait.h>
#include <tests/support/Program.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/RoomLog.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

class RawlogEntriesTest : public testing::Test
{
 protected:
  RawlogEntriesTest()
  {
    writePlain(asFrames(RoomLog(4)), path_);
    bytes_ = fileText(path_);
  }

  /** Reads a file of such bytes, and returns the number of entries. */
  int entriesOf(const std::string& bytes)
  {
    std::ofstream(path_, std::ios::binary) << bytes;
    RawlogEntries entries(path_);
    int count = 0;
    while (entries.next()) ++count;
    damage_ = entries.damage();
    EXPECT_EQ(entries.read(), count);
    EXPECT_FALSE(entries.next()) << "after the last one";
    return count;
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.path("rawlog");
  std::string bytes_, damage_;
};

TEST_F(RawlogEntriesTest, AreThoseOfTheFileBitForBit)
{
  const RoomLog log(4);
  RawlogEntries entries(path_);
  for (const auto& step : log.steps)
  {
    ASSERT_TRUE(entries.next());
    const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entries.next());
    ASSERT_TRUE(frame);
    const auto scan = frame->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    ASSERT_EQ(scan->getScanSize(), step.scan->getScanSize());
    for (std::size_t ray = 0; ray < scan->getScanSize(); ++ray)
      EXPECT_EQ(scan->getScanRange(ray), step.scan->getScanRange(ray));
    EXPECT_EQ(scan->timestamp, step.scan->timestamp);
    EXPECT_EQ(scan->sensorPose, step.scan->sensorPose);
  }
  EXPECT_FALSE(entries.next());
  EXPECT_EQ(entries.damage(), "");
  EXPECT_EQ(entries.shareRead(), 1);
}

TEST_F(RawlogEntriesTest, WhereverAFileIsCutTheEntriesBeforeComeOut)
{
  int last = 0;
  for (std::size_t cut = 0; cut < bytes_.size(); cut += 500)
  {
    const int entries = entriesOf(bytes_.substr(0, cut));
    EXPECT_GE(entries, last) << cut;
    last = entries;
  }
  EXPECT_EQ(last, 7) << "the last of eight is cut";
}

TEST_F(RawlogEntriesTest, AFlippedByteAnywhereHarmsNothingBeforeIt)
{
  RandomNumbers random(20);
  SCOPED_TRACE(random.seedText());
  const double bytesOfAnEntry = static_cast<double>(bytes_.size()) / 8;
  for (int i = 0; i < 500; ++i)
  {
    std::string damaged = bytes_;
    const auto at =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes_.size()) - 1));
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.integer(0, 7)));
    const int before = static_cast<int>(static_cast<double>(at) / bytesOfAnEntry) / 2 * 2;
    EXPECT_GE(entriesOf(damaged), before) << "byte " << at;
  }
}

// The count of the ranges of the first scan is followed by as many floats.
TEST_F(RawlogEntriesTest, LengthsThatAFileCannotHoldAreDamage)
{
  const RoomLog log(4);
  const auto rays = static_cast<std::uint32_t>(log.steps[0].scan->getScanSize());
  std::string count(4, '\0'), huge("\xFF\xFF\xFF\x3F", 4);
  std::memcpy(count.data(), &rays, 4);
  const auto at = bytes_.find(count);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(entriesOf(std::string(bytes_).replace(at, 4, huge)), 1);
  EXPECT_NE(damage_.find("read 1 entries, then: "), std::string::npos) << damage_;
}

TEST_F(RawlogEntriesTest, TheProcessEndsWithTheirReader)
{
  {
    RawlogEntries entries(path_);
    ASSERT_TRUE(entries.next());
  }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(RawlogEntriesTest, TheMemoryToDecodeAFileIsBounded)
{
  constexpr std::size_t kMegabyte = 1 << 20;
  EXPECT_EQ(decodingMemory_bytes(100), 48 * kMegabyte);
  EXPECT_EQ(decodingMemory_bytes(20 * kMegabyte), 160 * kMegabyte);
  EXPECT_EQ(decodingMemory_bytes(5000 * kMegabyte), 1024 * kMegabyte);
  EXPECT_EQ(decodingMemory_bytes(static_cast<std::size_t>(-1)), 1024 * kMegabyte);
}
}  // namespace
}  // namespace psmks
