/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/ErrorStatistics.h>
#include <psmks/eval/Relations.h>

#include <limits>
#include <vector>

namespace psmks
{
/** Relations that span less time measure single matches; longer ones measure drift. */
constexpr double kShortSpan_s = 5;

/** The errors of the relations whose span is at least min_s and less than end_s. */
std::vector<PairError> errorsSpanning(const std::vector<RelationError>& relations, double min_s = 0,
                                      double end_s = std::numeric_limits<double>::infinity());

/** Statistics of the errors of relations; of none if the trajectory has no poses at their stamps.
 */
struct RelationStatistics
{
  PairErrorStatistics all;
  PairErrorStatistics shortSpans;  //!< of the relations that span less than kShortSpan_s
};

/** Computes the statistics of a trajectory.
 *  @param limit of an error that counts as within */
RelationStatistics relationStatistics(const Trajectory& estimate,
                                      const std::vector<Relation>& relations,
                                      const PairError& limit = kSuccessLimit);
}  // namespace psmks
