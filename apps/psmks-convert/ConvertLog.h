/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>
#include <apps/support/ExitCode.h>

namespace psmks
{
/** Converts a log to another log or to scan pairs. If something was wrong, one sentence on stderr
 * says so.
 *  @throws ProgramError if the input cannot be read or the output cannot be written */
ExitCode convertLog(const CommandLine& commandLine);
}  // namespace psmks
