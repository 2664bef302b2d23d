/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>
#include <psmks/slam/PosedScan.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** The poses of a path at scans with a usable match, and the first pose. At the other scans the
 * path follows the odometry until the next match corrects it. */
struct MatchedPath
{
  Trajectory estimate, odometry;
  std::vector<std::size_t> scans;  //!< index of each pose on the whole path

  explicit MatchedPath(const std::vector<PosedScan>& path);
};
}  // namespace psmks
