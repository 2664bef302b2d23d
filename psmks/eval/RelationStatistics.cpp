/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/RelationStatistics.h>

namespace psmks
{
std::vector<PairError> errorsSpanning(const std::vector<RelationError>& relations, double min_s,
                                      double end_s)
{
  std::vector<PairError> errors;
  for (const auto& [span_s, error_m, error_rad] : relations)
    if (span_s >= min_s && span_s < end_s) errors.push_back({error_m, error_rad});
  return errors;
}

RelationStatistics relationStatistics(const Trajectory& estimate,
                                      const std::vector<Relation>& relations,
                                      const PairError& limit)
{
  const auto errors = relationErrors(estimate, relations);
  return {errorStatistics(errorsSpanning(errors), limit),
          errorStatistics(errorsSpanning(errors, 0, kShortSpan_s), limit)};
}
}  // namespace psmks
