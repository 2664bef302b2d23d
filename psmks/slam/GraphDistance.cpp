/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/GraphDistance.h>

#include <limits>
#include <queue>

namespace psmks
{
namespace
{
using Neighbours = std::vector<std::vector<std::pair<std::size_t, double>>>;

Neighbours neighboursOf(const PoseGraph& graph)
{
  Neighbours neighbours(graph.poses().size());
  for (const PoseLink& link : graph.links())
  {
    const double length_m = link.T_from_to.translation().norm();
    neighbours[link.from].emplace_back(link.to, length_m);
    neighbours[link.to].emplace_back(link.from, length_m);
  }
  return neighbours;
}
}  // namespace

/** Dijkstra. */
std::vector<double> graphDistances_m(const PoseGraph& graph, std::size_t from)
{
  const Neighbours neighbours = neighboursOf(graph);
  std::vector<double> distance_m(neighbours.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distance_m[from] = 0;
  open.emplace(0, from);
  while (!open.empty())
  {
    const auto [here_m, node] = open.top();
    open.pop();
    if (here_m > distance_m[node]) continue;
    for (const auto& [next, length_m] : neighbours[node])
    {
      if (here_m + length_m >= distance_m[next]) continue;
      distance_m[next] = here_m + length_m;
      open.emplace(distance_m[next], next);
    }
  }
  return distance_m;
}
}  // namespace psmks
