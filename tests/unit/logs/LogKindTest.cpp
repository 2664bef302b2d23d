/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/LogKind.h>
#include <psmks/logs/OpenLog.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/CarmenText.h>
#include <tests/unit/logs/RoomLog.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

class LogKindTest : public testing::Test
{
 protected:
  LogKind kindOf(const std::string& content) const
  {
    std::ofstream(path_, std::ios::binary) << content;
    return recogniseLog(path_);
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.path("file");
};

TEST_F(LogKindTest, LogsThatPsmksReadsAreKnown)
{
  EXPECT_EQ(kindOf("# a log\n" + flaser(std::vector<double>(181, 2.0), {}, 1)).reading,
            LogReading::Carmen);
  EXPECT_EQ(kindOf("#ROSBAG V2.0\n\x45\0\0\0").reading, LogReading::RosBag);
  writeGzipped(asFrames(RoomLog(2)), path_);
  EXPECT_EQ(recogniseLog(path_).reading, LogReading::Rawlog);
}

TEST_F(LogKindTest, BinaryFilesOfOthersAreNamed)
{
  const std::string null(1, '\0');
  const std::pair<std::string, const char*> expected[] = {
      {"SQLite format 3" + null + "more", "ROS 2 bag (SQLite"},
      {"\x89MCAP0\r\n", "ROS 2 bag (MCAP)"},
      {"ASTM-E57" + null, "E57"},
      {"\xD4\xC3\xB2\xA1\x02", "pcap"},
      {"# .PCD v0.7\nVERSION 0.7\n", "PCD"},
      {"PK\x03\x04", "ZIP"},
      {std::string(257, 'x') + "ustar", "tar"}};
  for (const auto& [content, kind] : expected)
  {
    EXPECT_EQ(kindOf(content).reading, LogReading::None) << kind;
    EXPECT_TRUE(says(kindOf(content).seems, {kind}));
  }
}

TEST_F(LogKindTest, TextsThatAreNoLogAreNamedByTheReader)
{
  const std::pair<const char*, const char*> expected[] = {
      {"time,x,y\n1,2,3\n", "CSV"},
      {"{\"a\": 1}\n", "JSON"},
      {"# trajectory\n1 2.5 -3e-2 0 0 0 0 1\n", "rows of numbers"},
      {"<html>\n", "XML"},
      {"[psmks]\n", "configuration"}};
  for (const auto& [content, kind] : expected)
  {
    std::ofstream(path_) << content;
    EXPECT_TRUE(says(openLog(path_)->damage(), {kind, "CARMEN logs and ROS 1 bags"}));
  }
}

TEST_F(LogKindTest, AFolderIsAFolderUnlessItIsARosTwoBag)
{
  const std::string folder = folder_.path("bag");
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(says(openLog(folder)->damage(), {"a folder"}));
  std::ofstream(folder + "/metadata.yaml") << "rosbag2_bagfile_information:\n";
  EXPECT_TRUE(says(openLog(folder)->damage(), {"ROS 2 bag", "rosbags-convert"}));
}
}  // namespace
}  // namespace psmks
