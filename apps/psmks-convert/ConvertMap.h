/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>

namespace psmks
{
/** Converts an ActivMedia map to a CSV file of its walls with the columns x1_m,y1_m,x2_m,y2_m.
 *  @throws ProgramError if the input cannot be read or the output cannot be written */
void convertMap(const CommandLine& commandLine);
}  // namespace psmks
