/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-simulate/CommandLine.h>

namespace psmks
{
/** One run of the program: loads the world, drives, writes all files and the summary.
 *  @throws ProgramError */
void simulateDrive(const CommandLine& commandLine);
}  // namespace psmks
