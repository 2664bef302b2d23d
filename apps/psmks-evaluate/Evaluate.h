/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-evaluate/CommandLine.h>

namespace psmks
{
/** One run of the program: reads, compares, prints and writes the tables, draws.
 *  @throws ProgramError */
void evaluate(CommandLine& commandLine);
}  // namespace psmks
