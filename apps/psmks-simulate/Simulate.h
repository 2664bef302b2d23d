/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-simulate/CommandLine.h>

namespace psmks
{
/** Runs the program: loads the world, drives, writes all files and prints the summary.
 *  @throws ProgramError if an input cannot be read or an output cannot be written */
void simulateDrive(const CommandLine& commandLine);
}  // namespace psmks
