/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

#include <limits>
#include <vector>

namespace psmks
{
/** @file
 * The collinearity statistic of three neighbouring rays.
 *
 * On a straight line the inverse range is linear in the direction of the ray, equation (1) of
 * docs/derivations.md. Three neighbouring rays at the even spacing d therefore obey
 *
 *     1/r(i-1) - 2 cos(d) / r(i) + 1/r(i+1) = 0
 *
 * exactly, whatever the line. The statistic is the left side, divided by the standard deviation
 * that it would have if short ranges had a standard deviation of 1 m. On a straight wall it is a
 * sample of the range noise, in metres; at corners and jumps it is much larger. */

/** An interval of ranges, from `from_m` (included) to `to_m` (excluded). */
struct RangeSpan
{
  double from_m = 0, to_m = std::numeric_limits<double>::infinity();

  bool holds(double range_m) const { return range_m >= from_m && range_m < to_m; }
};

/** Squared collinearity statistics of all rays within a span that are valid like both of their
 * neighbours. The first and the last position have no statistic.
 *  @param rays the columns of a scan; its noise tells how the variance grows with the range
 *  @param[out] statistics_m2 in the order of the positions; what it held is replaced
 *  @param span the range of the middle ray has to lie in it */
void collinearityStatistics(const RaySoA& rays, std::vector<double>& statistics_m2,
                            const RangeSpan& span = {});

/** Standard deviation of a short range as the rays of a span show it: the median of the absolute
 * collinearity statistics up to 20 cm, scaled to a standard deviation. Larger statistics lie on
 * edges and are left out. Nothing else is clipped, so the estimate also holds for crowded scans, in
 * which most rays lie on edges, and for ranges rounded to cells, whose errors are not normal.
 *  @param scratch storage for one number per ray
 *  @return metres; 0 where fewer than 20 statistics are left */
double estimateRangeSigma_m(const RaySoA& rays, std::vector<double>& scratch,
                            const RangeSpan& span = {});

/** Whether estimateRangeSigma_m() may exceed a value. A count over some sixty of the statistics
 * answers it many times faster than the median over all of them.
 *  @return false where the estimate is almost certainly below `sigma_m`, true where it may be above
 */
bool mayShowNoiseAbove(const RaySoA& rays, double sigma_m);

/** Position of a closed scan across which no line runs: the first one after an invalid ray, else
 * the one with the largest collinearity statistic. Lines that are grown from there are not cut at
 * the seam of the grid.
 *  @param rays the columns of a closed scan, in the order of the grid
 *  @return a position; 0 where no ray is valid */
int strongestBreak(const RaySoA& rays);
}  // namespace psmks
