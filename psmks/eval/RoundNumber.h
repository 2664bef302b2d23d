/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** The greatest number of the form 1, 2 or 5 times a power of ten that is at most x, for distances
 * of lines of a grid.
 *  @param x > 0 */
double roundNumber(double x);
}  // namespace psmks
