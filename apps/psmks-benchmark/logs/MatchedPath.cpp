/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/MatchedPath.h>

namespace psmks
{
MatchedPath::MatchedPath(const std::vector<PosedScan>& path)
{
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const PosedScan& scan = path[i];
    if (i > 0 && !scan.isMatched()) continue;
    scans.push_back(i);
    estimate.push_back({scan.stamp_s(), scan.T_world_robot.pose});
    odometry.push_back({scan.stamp_s(), scan.T_world_odometry});
  }
}
}  // namespace psmks
