/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/logs/MatchedPath.h>
#include <apps/psmks-benchmark/report/LogsPage.h>
#include <psmks/eval/Relations.h>
#include <psmks/slam/PosedScan.h>

#include <cstddef>
#include <string>
#include <vector>

namespace psmks
{
/** The motions of a path that are farthest from the truth. The matched scans at both ends of a true
 * motion form a pair, with the motion of the path as the result and the odometry as the guess.
 *  @param truth short motions
 *  @param count largest number of motions; the worst comes first */
DrawnRun worstMotions(const std::string& title, const std::vector<PosedScan>& path,
                      const MatchedPath& matched, const std::vector<Relation>& truth,
                      std::size_t count);
}  // namespace psmks
