/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

#include <Eigen/Core>

namespace psmks
{
/** The covariance of (x, y, phi) that the method assigns to a match, in the reference frame (Diosi
 *  and Kleeman 2007): that of a room or, along its direction, of a corridor, times a
 *  factor that grows with the error index, never below 1. A rule of thumb of its authors, not an
 *  estimate.
 *
 *  @param errorIndex_m finite, >= 0 */
Eigen::Matrix3d psmCovariance(const PsmScan& reference, double errorIndex_m,
                              const PsmOptions& options);
}  // namespace psmks
