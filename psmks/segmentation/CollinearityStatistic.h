/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

#include <limits>
#include <vector>

namespace psmks
{
/* On a straight line 1/r = u.(cos b, sin b), so three neighbouring rays at equal spacing d obey
 *
 *     1/r(i-1) - 2 cos(d) / r(i) + 1/r(i+1) = 0
 *
 * exactly, whatever the line (docs/algorithm.md). Divided by its standard deviation for a sigma of
 * 1 m at short ranges, which grows as the noise of the rays does, the left side measures noise on
 * straight walls and grows at corners and jumps. */

/** Some of the ranges of a scan. */
struct RangeSpan
{
  double from_m = 0, to_m = std::numeric_limits<double>::infinity();

  bool holds(double range_m) const { return range_m >= from_m && range_m < to_m; }
};

/** Values of the test, squared, in m^2 of noise of short ranges, of every ray of a span that is
 * valid with both neighbours.
 *  @param[out] statistics_m2 in the order of the positions, the others left out */
void collinearityStatistics(const RaySoA& rays, std::vector<double>& statistics_m2,
                            const RangeSpan& span = {});

/** Robust standard deviation of a range as the rays of a span show it: median of the three-ray
 * tests up to 20 cm, for larger ones lie on edges. 0 where fewer than 20 are left. Holds for
 * crowded scans, in which most rays lie on edges, and for ranges rounded to cells, whose noise has
 * no bell shape. */
double estimateRangeSigma_m(const RaySoA& rays, std::vector<double>& scratch,
                            const RangeSpan& span = {});

/** False where that estimate is surely below a value: a count over some of the tests, many times
 * faster than the median. */
bool mayShowNoiseAbove(const RaySoA& rays, double sigma_m);

/** Ray of a closed scan where no line can pass: one after an invalid ray, else the one with the
 * largest test. Lines are grown from there, so that the seam of the grid is no edge.
 *  @param rays in the order of the grid */
int strongestBreak(const RaySoA& rays);
}  // namespace psmks
