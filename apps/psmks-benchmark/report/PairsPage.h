/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/pairs/PairsSetResult.h>
#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <psmks/eval/Table.h>

#include <string>
#include <vector>

namespace psmks
{
/** The comparison of matchers on sets of pairs as an HTML page: the tables; for each set and guess
 * the distributions of errors and times; the areas of convergence, if they were measured; and
 * folded drawings of the worst pairs of each matcher. */
std::string pairsPage(const PageOrigin& origin, const std::vector<Table>& tables,
                      const std::vector<PairsSetResult>& sets);
}  // namespace psmks
