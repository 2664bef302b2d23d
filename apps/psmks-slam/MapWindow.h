/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>

namespace psmks
{
/** Checks that a window can be opened.
 *  @throws ProgramError if there is no display */
void requireDisplay();

/** Shows a map in a 3D window until the user closes it. */
void showMap(const ScanMap& map);
}  // namespace psmks
