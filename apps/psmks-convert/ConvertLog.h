/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>
#include <apps/support/ExitCode.h>

namespace psmks
{
/** From a log to another log or to pairs.
 *  @return the exit code, where it is not ok after one sentence on stderr
 *  @throws ProgramError */
ExitCode convertLog(const CommandLine& commandLine);
}  // namespace psmks
