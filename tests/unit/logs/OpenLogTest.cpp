/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/CarmenReader.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/logs/RawlogReader.h>
#include <tests/support/ScratchFolder.h>
#include <tests/unit/logs/CarmenText.h>
#include <tests/unit/logs/RoomLog.h>

#include <fstream>

namespace psmks
{
namespace
{
using namespace test;

class OpenLogTest : public testing::Test
{
 protected:
  const ScratchFolder folder_;
  const std::string path_ = folder_.path("file");
};

TEST_F(OpenLogTest, TheContentTellsTheKindWhateverTheName)
{
  std::ofstream(path_) << flaser(std::vector<double>(181, 2.0), {}, 1);
  EXPECT_TRUE(dynamic_cast<CarmenReader*>(openLog(path_).get()));
  writeGzipped(asFrames(RoomLog(2)), path_);
  EXPECT_TRUE(dynamic_cast<RawlogReader*>(openLog(path_).get()));
  writePlain(asFrames(RoomLog(2)), path_);
  EXPECT_TRUE(dynamic_cast<RawlogReader*>(openLog(path_).get()));
}

TEST_F(OpenLogTest, TheSensorIsHandedOn)
{
  std::ofstream(path_) << flaser(std::vector<double>(181, 2.0), {}, 1);
  LogOptions options;
  options.sensorLabel = "RLASER";
  LaserFrame frame;
  const auto reader = openLog(path_, options);
  EXPECT_FALSE(reader->next(frame));
  EXPECT_EQ(reader->scansOfSensors().at("FLASER"), 1);
}

//  the scanner SAFETY gave the first scan of the log, and FRONT all the others
TEST_F(OpenLogTest, OfSeveralSensorsTheOneWithMostScansIsRead)
{
  RoomLog log(6);
  log.steps[0].scan->sensorLabel = "SAFETY";
  writeGzipped(asFrames(log), path_);
  LaserFrame frame;
  const auto reader = openLog(path_);
  int scans = 0;
  while (reader->next(frame)) ++scans;
  EXPECT_EQ(scans, 5);
  EXPECT_EQ(reader->sensorLabel(), "FRONT");
  LogOptions options;
  options.sensorLabel = "SAFETY";
  EXPECT_TRUE(openLog(path_, options)->next(frame));
}

TEST_F(OpenLogTest, AMissingFileGivesAReaderThatSaysSo)
{
  EXPECT_NE(openLog(path_)->damage().find("no such file"), std::string::npos);
}
}  // namespace
}  // namespace psmks
