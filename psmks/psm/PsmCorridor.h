/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

#include <optional>

namespace psmks
{
/** Whether a scan shows a corridor (Diosi and Kleeman 2007): the directions of the
 *  chords between neighbouring points of its surfaces, median filtered, spread by less than
 *  corridorSpread_rad. As directions 0 and 180 degrees are the same, the spread is taken a second
 *  time with all of them turned by 36 degrees, and the smaller counts.
 *
 *  @return the direction of the corridor in the sensor frame, in [0, pi); nothing for a room or
 *  where there are no chords */
std::optional<double> corridorDirection_rad(const PsmScan& scan, const PsmOptions& options);
}  // namespace psmks
