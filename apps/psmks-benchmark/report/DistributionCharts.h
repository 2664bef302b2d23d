/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/pairs/PairsSetResult.h>
#include <psmks/eval/Chart.h>

#include <string>
#include <vector>

namespace psmks
{
/** How the errors of position and heading and the times are distributed over the pairs of a set:
 * for every limit the share of the matches within it, one line a matcher, and one for the bound of
 * the errors, where it is known. A failed match counts with the error of its guess.
 *  @param guess of the runs that are shown */
std::vector<Chart> distributionCharts(const PairsSetResult& set, const std::string& guess);
}  // namespace psmks
