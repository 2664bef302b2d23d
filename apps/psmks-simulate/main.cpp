/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/CommandLine.h>
#include <apps/psmks-simulate/Simulate.h>
#include <apps/support/ExitCode.h>
#include <psmks/sim/Worlds.h>

#include <iostream>

namespace psmks
{
namespace
{
void run(const CommandLine& commandLine)
{
  if (!commandLine.listWorlds) return simulateDrive(commandLine);
  for (const auto& name : siteNames()) std::cout << name << '\n';
}

ExitCode complain(ExitCode code, const std::exception& error)
{
  std::cerr << "psmks-simulate: " << error.what() << '\n';
  return code;
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  const psmks::ParsedCommandLine parsed = psmks::parseCommandLine(argc, argv);
  if (!parsed.commandLine) return parsed.exitCode;
  try
  {
    psmks::run(*parsed.commandLine);
    return psmks::kOk;
  }
  catch (const psmks::ProgramError& error)
  {
    return psmks::complain(error.exitCode, error);
  }
  catch (const std::exception& error)
  {
    return psmks::complain(psmks::kUsage, error);
  }
}
