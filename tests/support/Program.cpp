/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tests/support/Program.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace psmks
{
ProgramRun runProgram(const std::string& command)
{
  const std::string base = testing::TempDir() + "psmks_program_" + std::to_string(getpid());
  const std::string output = base + ".out", errors = base + ".err";
  const int status =
      std::system((command + " </dev/null >'" + output + "' 2>'" + errors + "'").c_str());

  ProgramRun run;
  if (WIFEXITED(status)) run.exitCode = WEXITSTATUS(status);
  run.output = fileText(output);
  run.errors = fileText(errors);
  std::remove(output.c_str());
  std::remove(errors.c_str());
  return run;
}

std::string fileText(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}
}  // namespace psmks
