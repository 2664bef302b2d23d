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
/** Where a path is furthest from the truth: the matched scans at both ends of a true motion as a
 * pair, the current one where the path has it; the odometry is the guess.
 *  @param truth short motions
 *  @param count of motions at most, the worst first */
DrawnRun worstMotions(const std::string& title, const std::vector<PosedScan>& path,
                      const MatchedPath& matched, const std::vector<Relation>& truth,
                      std::size_t count);
}  // namespace psmks
