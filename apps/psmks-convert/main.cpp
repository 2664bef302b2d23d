/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-convert/CommandLine.h>
#include <apps/psmks-convert/ConvertLog.h>
#include <apps/psmks-convert/ConvertMap.h>
#include <apps/support/Overwriting.h>

#include <filesystem>

namespace psmks
{
namespace
{
void checkOutput(const CommandLine& commandLine)
{
  const std::string& output = commandLine.output;
  if (output.empty()) return;
  std::error_code ignored;
  if (std::filesystem::equivalent(commandLine.input, output, ignored))
    throw ProgramError(kUsage, "'" + output + "' is the input");
  requireReplaceable(output, commandLine.overwrite);
}

ExitCode run(const CommandLine& commandLine)
{
  checkOutput(commandLine);
  if (commandLine.outputKind() != OutputKind::Segments) return convertLog(commandLine);
  convertMap(commandLine);
  return kOk;
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  return psmks::runProgram(psmks::commandLineSyntax(), argc, argv, psmks::run);
}
