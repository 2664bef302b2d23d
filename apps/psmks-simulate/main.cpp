/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/CommandLine.h>
#include <apps/psmks-simulate/Simulate.h>
#include <psmks/sim/Worlds.h>

#include <iostream>

namespace psmks
{
namespace
{
ExitCode run(const CommandLine& commandLine)
{
  if (!commandLine.listWorlds)
    simulateDrive(commandLine);
  else
    for (const auto& name : siteNames()) std::cout << name << '\n';
  return kOk;
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  return psmks::runProgram(psmks::commandLineSyntax(), argc, argv, psmks::run);
}
