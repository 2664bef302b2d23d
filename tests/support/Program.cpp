/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <sys/wait.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace psmks
{
ProgramRun runProgram(const std::string& command)
{
  const test::ScratchFolder folder;
  const std::string output = folder.path("output"), errors = folder.path("errors");
  const int status =
      std::system((command + " </dev/null >'" + output + "' 2>'" + errors + "'").c_str());

  ProgramRun run;
  if (WIFEXITED(status)) run.exitCode = WEXITSTATUS(status);
  run.output = fileText(output);
  run.errors = fileText(errors);
  return run;
}

bool hasGnuplot() { return runProgram("gnuplot --version").exitCode == 0; }

std::string fileText(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}
}  // namespace psmks
