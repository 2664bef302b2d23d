/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <vector>

namespace psmks
{
/** The value below which a share p of the values lies, interpolated linearly between neighbours:
 * the smallest for 0, the largest for 1. NaN without values.
 *  @param p 0 to 1 */
double quantile(std::vector<double> values, double p);

/** The median, quantile(values, 0.5). */
double median(std::vector<double> values);

/** The arithmetic mean; NaN without values. */
double mean(const std::vector<double>& values);

/** The share of the values that are at most `limit`; NaN without values. */
double shareBelow(const std::vector<double>& values, double limit);
}  // namespace psmks
