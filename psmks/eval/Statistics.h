/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <vector>

namespace psmks
{
/** The value below which a share p of the values lies, interpolated linearly between neighbours
 *  (0 = the smallest, 1 = the largest). NaN where there are no values.
 *  @param p 0 to 1 */
double quantile(std::vector<double> values, double p);

/** quantile(values, 0.5). */
double median(std::vector<double> values);

/** The arithmetic mean; NaN where there are no values. */
double mean(const std::vector<double>& values);

/** Share of the values that are at most `limit`; NaN where there are no values. */
double shareBelow(const std::vector<double>& values, double limit);
}  // namespace psmks
