/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Pose2.h>
#include <psmks/core/Scan.h>

namespace psmks
{
/** Share of the returns of the current scan that lie near what the reference saw at their bearing,
 * 0 to 1, at a pose known to some decimetres; 0 where the ranges of one do not fit its grid. Small
 * where the scans look at different things: past each other, or at two sides of a wall. */
double overlap(const Scan& reference, const Scan& current, const Pose2& T_ref_cur);
}  // namespace psmks
