/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/CommandLine.h>
#include <apps/psmks-slam/Slam.h>

#include <iostream>

namespace psmks
{
namespace
{
/** The options in the order of rising priority: the defaults, the file of the sensor, the file of
 * options, the flags. */
SlamOptions effectiveOptions(const CommandLine& commandLine)
{
  SlamOptions options;
  if (commandLine.matcher == "psmks-paper")
    options.matching.matcher = MatcherOptions::paperScheme();
  if (!commandLine.sensorFile.empty()) options.load(commandLine.sensorFile);
  if (!commandLine.config.empty()) options.load(commandLine.config);
  if (commandLine.reference) options.set("reference.choice=" + *commandLine.reference);
  for (const auto& assignment : commandLine.assignments) options.set(assignment);
  return options;
}

ExitCode run(const CommandLine& commandLine)
{
  SlamOptions options = effectiveOptions(commandLine);
  if (commandLine.onlyPrints())
  {
    std::cout << (commandLine.printConfig ? options.toIni() : options.toMarkdown());
    return kOk;
  }
  return Slam(commandLine, options).run();
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  return psmks::runProgram(psmks::commandLineSyntax(), argc, argv, psmks::run);
}
