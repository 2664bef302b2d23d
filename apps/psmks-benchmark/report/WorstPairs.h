/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsSummary.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** The indices of the records with the largest errors, the worst first. Translation and rotation
 * are divided by the limits of a success, and the larger of the two counts.
 *  @param count largest number of records
 *  @param limit of the errors of a success */
std::vector<std::size_t> worstRecords(const std::vector<PairRecord>& records, std::size_t count,
                                      const PairError& limit = kSuccessLimit);
}  // namespace psmks
