/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/GaussNewton.h>

namespace psmks
{
/** What normal equations of (x, y, phi) still say once all that they say about the position along a
 * direction is given up: that position is eliminated (Schur complement), so that the information
 * along it is zero and what is known of the rest is what is known with it unknown.
 *  @param direction unit vector, reference axes */
NormalEquations withoutDirection(const NormalEquations& scans, const Eigen::Vector2d& direction);

/** What normal equations still say once all that they say about the heading itself is given up:
 * they fix the position at any given heading as before, see positionPerHeading(), and no heading
 * is better than another. */
NormalEquations withoutHeading(const NormalEquations& scans);
}  // namespace psmks
