/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/support/ProgramTest.h>
#include <tests/support/Says.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace psmks::test
{
ProgramTest::ProgramTest(std::string program) : program_(std::move(program)) {}

ProgramRun ProgramTest::run(const std::string& arguments, const std::string& prefix) const
{
  return runProgram("cd '" + folder_.path() + "' && " + prefix + " '" + program_ + "' " +
                    arguments);
}

void ProgramTest::expectOneSentence(const ProgramRun& run) const
{
  const std::string name = std::filesystem::path(program_).filename().string();
  EXPECT_EQ(run.errors.rfind(name + ": ", 0), 0u) << run.errors;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
}

void ProgramTest::expectError(const ProgramRun& run, int exitCode,
                              std::initializer_list<std::string> words) const
{
  EXPECT_EQ(run.exitCode, exitCode) << run.errors;
  expectOneSentence(run);
  EXPECT_TRUE(says(run.errors, words));
}
}  // namespace psmks::test
