/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/ErrorStatistics.h>
#include <psmks/eval/Relations.h>

#include <limits>
#include <vector>

namespace psmks
{
/** Relations that span less time tell of single matches, others of drift. */
constexpr double kShortSpan_s = 5;

/** The errors of the relations that span a time from min_s up to, but not including, end_s. */
std::vector<PairError> errorsSpanning(const std::vector<RelationError>& relations, double min_s = 0,
                                      double end_s = std::numeric_limits<double>::infinity());

/** What the errors of relations come to; of none where a trajectory has poses for none. */
struct RelationStatistics
{
  PairErrorStatistics all;
  PairErrorStatistics shortSpans;  //!< of those that span less than kShortSpan_s
};

/** @param limit of an error that counts as within */
RelationStatistics relationStatistics(const Trajectory& estimate,
                                      const std::vector<Relation>& relations,
                                      const PairError& limit = kSuccessLimit);
}  // namespace psmks
