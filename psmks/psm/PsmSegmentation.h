/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

namespace psmks
{
/** Numbers the surfaces of a scan whose ranges and tags are set: fills `segment` (Diosi and Kleeman
 *  2007). Going round counter-clockwise, a ray joins the one before it where
 *
 *   - their ranges differ by less than `break_m`, or
 *   - its range is within `break_m` of the straight continuation 2 r[i-1] - r[i-2] of two rays on
 *     one surface; or of two lone rays, which it then rescues: a surface seen at a grazing angle
 *     has jumps everywhere.
 *
 *  A ray without a reading ends a surface. A closed scan is gone round from its greatest jump, so
 *  that no surface ends at its first ray. */
void segmentPsmScan(double break_m, PsmScan& scan);
}  // namespace psmks
