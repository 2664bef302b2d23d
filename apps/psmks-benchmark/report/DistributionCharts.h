/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/pairs/PairsSetResult.h>
#include <psmks/eval/Chart.h>

#include <string>
#include <vector>

namespace psmks
{
/** Charts of the distributions of the errors of position and heading and of the times over the
 * pairs of a set. They show for each limit the share of the matches below it, with a line for each
 * matcher and one for the bound of the errors, if it is known. A failed match counts with the error
 * of its guess.
 *  @param guess kind of guess of the runs that are shown */
std::vector<Chart> distributionCharts(const PairsSetResult& set, const std::string& guess);
}  // namespace psmks
