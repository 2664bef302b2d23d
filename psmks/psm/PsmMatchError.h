/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

namespace psmks
{
/** The mean absolute difference of the ranges of two scans at one pose. Only pairs count of which
 * both ranges are Good and which differ by less than half of maxPairDifference_m.
 *  @return infinity if there are no such pairs */
double rangeErrorIndex_m(const PsmScan& reference, const PsmProjection& projection,
                         double maxPairDifference_m);

/** The mean distance of the points of a scan to the nearest points of the other; the greater of the
 * two directions. It compares each point with each, so its time grows with their product.
 *  @return infinity if a scan has no good ray */
double pointErrorIndex_m(const PsmScan& reference, const PsmScan& current, const Pose2& T_ref_cur);
}  // namespace psmks
