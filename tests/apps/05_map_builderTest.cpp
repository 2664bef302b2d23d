/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>

#include <filesystem>
#include <regex>

namespace psmks
{
namespace
{
const std::string kInis = "/usr/share/mrpt/config_files/icp-slam/icp-slam_demo_";

/** Two of these ini files fill point maps, one a grid as well. MRPT's test of icp-slam asks for a
 * pose near (3.45, -18.04, -86.5 deg); of the 225 scans MRPT's own builder fills 12,300 cells. */
TEST(ExampleMapBuilder, MapsALoopByTheIniFilesOfIcpSlam)
{
  if (!std::filesystem::exists(kInis + "LM.ini")) GTEST_SKIP() << kInis << "* are not installed";
  for (const char* name : {"classic", "LM", "classic_gridmatch"})
  {
    const ProgramRun run = runProgram("'" PSMKS_PROGRAM "' '" + kInis + name + ".ini'");
    ASSERT_EQ(run.exitCode, 0) << name << ": " << run.errors;
    std::smatch said;
    ASSERT_TRUE(
        std::regex_search(run.output, said,
                          std::regex(R"((\d+) scans, (\d+) of them in the map, (\d+) cells\s+)"
                                     R"(the robot ends at x (\S+) m, y (\S+) m, phi (\S+) deg)")))
        << run.output;
    EXPECT_GE(std::stoi(said[1]), 224) << name;
    EXPECT_GT(std::stoi(said[2]), 20) << name;
    EXPECT_LE(std::stoi(said[3]), 8100) << name;
    EXPECT_NEAR(std::stod(said[4]), 3.45, 1) << name;
    EXPECT_NEAR(std::stod(said[5]), -18.04, 1) << name;
    EXPECT_NEAR(std::stod(said[6]), -86.5, 3) << name;
  }
}

TEST(ExampleMapBuilder, SaysWhatIsWrongWithALog)
{
  if (!std::filesystem::exists(kInis + "LM.ini")) GTEST_SKIP() << kInis << "* are not installed";
  const ProgramRun run = runProgram("'" PSMKS_PROGRAM "' '" + kInis + "LM.ini' missing.rawlog");
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_TRUE(test::says(run.errors, {"missing.rawlog"}));
}
}  // namespace
}  // namespace psmks
