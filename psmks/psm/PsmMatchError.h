/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

namespace psmks
{
/** How far apart two scans are: the mean absolute difference of the ranges that are Good on both
 *  sides and differ by less than half of maxPairDifference_m. Infinite where there are none. */
double rangeErrorIndex_m(const PsmScan& reference, const PsmProjection& projection,
                         double maxPairDifference_m);

/** The same by points: the mean distance of every point of a scan to the nearest of the other, the
 *  greater of both directions. Compares each with each. Infinite where a scan has no good ray. */
double pointErrorIndex_m(const PsmScan& reference, const PsmScan& current, const Pose2& T_ref_cur);
}  // namespace psmks
