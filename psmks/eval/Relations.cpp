/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/NumberRows.h>
#include <psmks/eval/PairError.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/StampIndex.h>

#include <cmath>

namespace psmks
{
std::vector<Relation> readRelations(const std::string& path)
{
  constexpr std::size_t kNumbers = 8;  // from_s to_s x y z roll pitch yaw
  std::vector<Relation> relations;
  for (const NumberRow& row : readNumberRows(path, "relation"))
  {
    const auto& n = row.numbers;
    if (n.size() != kNumbers) refuse(path, row, "expected 'from_s to_s x y z roll pitch yaw'");
    relations.push_back({n[0], n[1], {n[2], n[3], wrapAngle(n[7])}});
  }
  return relations;
}

std::vector<RelationError> relationErrors(const Trajectory& estimate,
                                          const std::vector<Relation>& relations)
{
  const StampIndex index(estimate);
  std::vector<RelationError> errors;
  for (const auto& [from_s, to_s, T_from_to] : relations)
  {
    const auto from = index.nearest(from_s, kStampTolerance_s);
    const auto to = index.nearest(to_s, kStampTolerance_s);
    if (!from || !to || !estimate[*from].hasHeading() || !estimate[*to].hasHeading()) continue;
    const Pose2 T_from_to_estimated = estimate[*from].pose.inverse() * estimate[*to].pose;
    const auto [error_m, error_rad] = pairError(T_from_to_estimated, T_from_to);
    errors.push_back({std::abs(to_s - from_s), error_m, error_rad});
  }
  return errors;
}
}  // namespace psmks
