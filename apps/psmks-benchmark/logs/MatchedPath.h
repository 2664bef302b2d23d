/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>
#include <psmks/slam/PosedScan.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** The poses of a path that a match stands for, and the first: where a scan failed, the path is
 * only as good as the odometry, and the next match puts it right again. */
struct MatchedPath
{
  Trajectory estimate, odometry;
  std::vector<std::size_t> scans;  //!< places on the whole path, one per pose

  explicit MatchedPath(const std::vector<PosedScan>& path);
};
}  // namespace psmks
