/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

#include <optional>

namespace psmks
{
/** Decides whether a scan shows a corridor (Diosi and Kleeman 2007): the standard deviation of the
 * directions of the chords between neighbouring points of its surfaces, median filtered, is less
 * than corridorSpread_rad. Directions of 0 and 180 degrees are the same, so it is computed a second
 * time with all directions turned by 36 degrees, and the smaller one counts.
 *
 *  @return the direction of the corridor in the sensor frame, in [0, pi); nothing for a room, and
 *          for a scan without chords */
std::optional<double> corridorDirection_rad(const PsmScan& scan, const PsmOptions& options);
}  // namespace psmks
