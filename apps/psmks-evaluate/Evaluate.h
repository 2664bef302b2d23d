/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-evaluate/CommandLine.h>

namespace psmks
{
/** Runs the program: reads and compares the trajectories, prints and writes the tables, draws the
 * figure.
 *  @throws ProgramError if a file cannot be read or written, or if there is nothing to compare */
void evaluate(CommandLine& commandLine);
}  // namespace psmks
