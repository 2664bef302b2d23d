/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/EdgePairing.h>

namespace psmks
{
namespace
{
/** The edge that is nearest to a point, of those on one side and within a distance; or null. */
const DepthEdge* nearestEdge(const std::vector<DepthEdge>& edges, const Eigen::Vector2d& point_m,
                             int step, double gate_m)
{
  const DepthEdge* nearest = nullptr;
  double best_m2 = gate_m * gate_m;
  for (const DepthEdge& edge : edges)
  {
    const double distance_m2 = (edge.point_m - point_m).squaredNorm();
    if (edge.step != step || distance_m2 >= best_m2) continue;
    best_m2 = distance_m2;
    nearest = &edge;
  }
  return nearest;
}

/** The distance of the current edge from the line of sight to the reference edge. */
RayTerm heldAcross(const DepthEdge& reference, const DepthEdge& current, const Eigen::Matrix2d& R)
{
  const Eigen::Vector2d across(-reference.sight.y(), reference.sight.x());
  const double sine = across.dot(R * current.sight);
  const double variance_m2 = reference.acrossVariance_m2 +
                             (1 - sine * sine) * current.acrossVariance_m2 +
                             sine * sine * current.alongVariance_m2;
  return {true, current.point_m, across, 0, 1 / variance_m2};
}
}  // namespace

int pairEdges(const std::vector<DepthEdge>& reference, const std::vector<DepthEdge>& current,
              const Pose2& T_ref_cur, double gate_m, std::vector<RayTerm>& pairs)
{
  if (!(gate_m > 0)) return 0;
  const Pose2 T_cur_ref = T_ref_cur.inverse();
  const Eigen::Matrix2d R = T_ref_cur.rotation();
  const std::size_t before = pairs.size();
  for (const DepthEdge& edge : current)
  {
    const DepthEdge* partner = nearestEdge(reference, T_ref_cur * edge.point_m, edge.step, gate_m);
    if (!partner || nearestEdge(current, T_cur_ref * partner->point_m, edge.step, gate_m) != &edge)
      continue;
    pairs.push_back(heldAcross(*partner, edge, R));
  }
  return static_cast<int>(pairs.size() - before);
}
}  // namespace psmks
