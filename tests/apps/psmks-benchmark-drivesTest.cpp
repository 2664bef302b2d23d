/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/ProgramTest.h>

#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
class PsmksBenchmarkDrives : public test::ProgramTest
{
 protected:
  PsmksBenchmarkDrives() : ProgramTest(PSMKS_PROGRAM) {}

  nlohmann::json rows(const std::string& flags)
  {
    const ProgramRun done = run("drives " + flags + " --json t.json");
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return nlohmann::json::parse(fileText(path("t.json"))).at("tables").at(0).at("rows");
  }
};
}  // namespace

TEST_F(PsmksBenchmarkDrives, HoldTheErrorOfEachSeedAgainstTheFloor)
{
  const auto drives = rows("--world office --minutes 1 --seeds 2 --first-seed 3");
  ASSERT_EQ(drives.size(), 2U);
  for (std::size_t d = 0; d < drives.size(); ++d)
  {
    const auto& drive = drives[d];
    EXPECT_EQ(drive.at("seed"), 3 + d);
    EXPECT_EQ(drive.at("scans"), 601) << "ten a second and the first one";
    EXPECT_EQ(drive.at("wrong_links"), 0);
    EXPECT_GT(drive.at("keyframes"), 5);
    EXPECT_LT(drive.at("mean_m"), 0.05) << "a minute in an office";
    EXPECT_GE(drive.at("max_m"), drive.at("mean_m"));
    EXPECT_GT(drive.at("floor_mean_m"), 0);
    EXPECT_LT(drive.at("mean_by_floor"), 5);
  }
}

TEST_F(PsmksBenchmarkDrives, TellTheTimeAndTheMemoryAlongTheWay)
{
  const auto tenths = rows("--world office --minutes 0.5 --tenths");
  ASSERT_EQ(tenths.size(), 10U);
  for (std::size_t t = 1; t < tenths.size(); ++t)
  {
    EXPECT_EQ(tenths[t].at("tenth"), t + 1);
    EXPECT_GT(tenths[t].at("way_km"), tenths[t - 1].at("way_km"));
    EXPECT_GE(tenths[t].at("keyframes"), tenths[t - 1].at("keyframes"));
    EXPECT_GT(tenths[t].at("scan_ms"), 0);
  }
}

TEST_F(PsmksBenchmarkDrives, AWorldThatDoesNotExistIsAUsageError)
{
  const ProgramRun done = run("drives --world moon");
  EXPECT_EQ(done.exitCode, 1);
  EXPECT_NE(done.errors.find("moon"), std::string::npos) << done.errors;
}
}  // namespace psmks
