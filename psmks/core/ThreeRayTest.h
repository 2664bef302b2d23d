/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/SegmentedScan.h>

#include <vector>

namespace psmks
{
/* On a straight line 1/r = u.(cos b, sin b), so three neighbouring rays at equal spacing d obey
 *
 *     1/r(i-1) - 2 cos(d) / r(i) + 1/r(i+1) = 0
 *
 * exactly, whatever the line (docs/algorithm.md). Divided by its standard deviation for a range
 * sigma of 1 m, the left side measures noise on straight walls and grows at corners and jumps. */

/** Value of the test at ray i in metres of range noise; infinity where i or a neighbour is missing.
 */
double threeRayTest_m(const SegmentedScan& scan, int ray);

/** Robust standard deviation of a range as the scan itself shows it (median absolute value of the
 *  three-ray test); 0 where fewer than 20 rays can be tested. Corners and clutter hardly move it
 * while they make up less than half of the scan. */
double estimateRangeSigma_m(const SegmentedScan& scan, std::vector<double>& scratch);

/** Ray of the strongest break of a closed scan: an invalid ray, else the largest three-ray test.
 * Lines are grown from there, so that the seam of the grid is no edge. */
int strongestBreak(const SegmentedScan& scan);
}  // namespace psmks
