/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <gtest/gtest.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
using test::says;
using test::thrownText;

class GroundTruthTest : public testing::Test
{
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  /** The ground truth of a log that has only this file beside it. */
  std::optional<std::string> found(const std::string& log, const std::string& file) const
  {
    std::ofstream(path(file)) << "0 0 0 0\n";
    const auto truth = groundTruthBeside(path(log));
    std::filesystem::remove(path(file));
    return truth;
  }

  const test::ScratchFolder folder_;
};

TEST_F(GroundTruthTest, LiesBesideItsLog)
{
  for (const char* log : {"drive.rawlog", "drive.log", "drive.log.gz", "drive.clf"})
    for (const char* file :
         {"drive.gt.tum", "drive.GT.txt", "drive.reference.tum", "drive_GT.txt", "drive.gt.txt"})
      EXPECT_EQ(found(log, file), path(file)) << log;
  EXPECT_EQ(found("drive.rawlog", "drive.rawlog.GT.txt"), path("drive.rawlog.GT.txt"));
}

TEST_F(GroundTruthTest, OfAnotherLogIsNotTaken)
{
  EXPECT_EQ(found("drive.rawlog", "other.gt.tum"), std::nullopt);
  EXPECT_EQ(found("drive.rawlog", "drive.tum"), std::nullopt);
  EXPECT_EQ(found("drive.day2.log.gz", "drive.gt.tum"), std::nullopt);
  EXPECT_EQ(found("drive.day2.log.gz", "drive.day2.gt.tum"), path("drive.day2.gt.tum"));
}

TEST_F(GroundTruthTest, RelationsLieBesideTheirLog)
{
  EXPECT_EQ(relationsBeside(path("drive.log.gz")), std::nullopt);
  std::ofstream(path("drive.relations")) << "0 1 0 0 0 0 0 0\n";
  EXPECT_EQ(relationsBeside(path("drive.log.gz")), path("drive.relations"));
  EXPECT_EQ(readTrueRelations(path("drive.relations")).size(), 1u);
}

TEST_F(GroundTruthTest, WhatCannotBeReadIsDamagedInput)
{
  EXPECT_TRUE(says(thrownText<ProgramError>([&] { readGroundTruth(path("none.tum")); }),
                   {"ground truth ", "none.tum", "no such file"}));
  std::ofstream(path("drive.relations")) << "0 1 0\n";
  EXPECT_TRUE(says(thrownText<ProgramError>([&] { readTrueRelations(path("drive.relations")); }),
                   {"relations ", "drive.relations:1", "expected"}));
}
}  // namespace
}  // namespace psmks
