/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/CommandLine.h>
#include <apps/psmks-evaluate/Evaluate.h>

namespace psmks
{
namespace
{
ExitCode run(CommandLine& commandLine)
{
  evaluate(commandLine);
  return kOk;
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  return psmks::runProgram(psmks::commandLineSyntax(), argc, argv, psmks::run);
}
