/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>

namespace psmks
{
namespace
{
const char* const kLog =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

/** The example writes into the folder in which it is started. */
ProgramRun runIn(const test::ScratchFolder& folder, const std::string& arguments = "")
{
  return runProgram("cd '" + folder.path() + "' && '" PSMKS_PROGRAM "' " + arguments);
}

TEST(ExampleLogToMap, WritesTheMapAndTheTrajectoryOfALoop)
{
  if (!std::filesystem::exists(kLog)) GTEST_SKIP() << kLog << " is not installed";
  const test::ScratchFolder folder;
  const ProgramRun run = runIn(folder);
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_TRUE(test::says(run.output, {"225 scans, 224 of them matched, 77 m driven"}));

  const Trajectory trajectory = readTrajectory(folder.path("trajectory.tum"));
  EXPECT_EQ(trajectory.size(), 225u);
  EXPECT_GT(std::filesystem::file_size(folder.path("map.png")), 10000u) << "an empty sheet is less";
}

TEST(ExampleLogToMap, SaysWhatIsWrongWithALog)
{
  const test::ScratchFolder folder;
  const ProgramRun run = runIn(folder, "missing.rawlog");
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_TRUE(test::says(run.errors, {"missing.rawlog", "no such file"}));
}
}  // namespace
}  // namespace psmks
