/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsSummary.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** Places of the records with the largest errors, the worst first. Translation and rotation count
 * in units of what a success may have, the larger of the two.
 *  @param count of places at most
 *  @param limit of a success */
std::vector<std::size_t> worstRecords(const std::vector<PairRecord>& records, std::size_t count,
                                      const PairError& limit = kSuccessLimit);
}  // namespace psmks
