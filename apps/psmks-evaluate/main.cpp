/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-evaluate/CommandLine.h>
#include <apps/psmks-evaluate/Evaluate.h>
#include <apps/support/ExitCode.h>

int main(int argc, char** argv)
{
  auto parsed = psmks::parseCommandLine(argc, argv);
  if (!parsed.commandLine) return parsed.exitCode;
  return psmks::exitCodeOf("psmks-evaluate",
                           [&parsed]
                           {
                             psmks::evaluate(*parsed.commandLine);
                             return psmks::kOk;
                           });
}
