/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

namespace psmks
{
/** Numbers the surfaces of a scan whose ranges and tags are set: fills `segment` (Diosi and Kleeman
 *  2007). Going round counter-clockwise, a ray joins the one before it if
 *
 *   - their ranges differ by less than `break_m`, or
 *   - its range is within `break_m` of the linear continuation 2 r[i-1] - r[i-2] of two rays that
 *     lie on one surface or on none. In the second case all three then form a surface: seen at a
 *     grazing angle, it has jumps between all its rays.
 *
 *  A ray without a reading ends a surface. A closed scan is traversed from its greatest jump on, so
 *  that no surface is cut at the first ray. */
void segmentPsmScan(double break_m, PsmScan& scan);
}  // namespace psmks
