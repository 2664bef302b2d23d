/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>

namespace psmks
{
/** From an ActivMedia map to its walls: a row a segment, x1_m,y1_m,x2_m,y2_m.
 *  @throws ProgramError */
void convertMap(const CommandLine& commandLine);
}  // namespace psmks
