/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmScan.h>

#include <Eigen/Core>

namespace psmks
{
/** The covariance of (x, y, phi) that the method assigns to a match, in the reference frame (Diosi
 * and Kleeman 2007). It is a fixed matrix for rooms, and another one for corridors, turned to the
 * direction of the corridor, times a factor >= 1 that grows with the error index. This is a rule of
 * thumb of the authors, not an estimate from the data.
 *
 *  @param errorIndex_m finite, >= 0 */
Eigen::Matrix3d psmCovariance(const PsmScan& reference, double errorIndex_m,
                              const PsmOptions& options);
}  // namespace psmks
