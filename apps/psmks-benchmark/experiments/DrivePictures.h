/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/MethodRun.h>
#include <psmks/eval/Figure.h>

#include <vector>

namespace psmks
{
/** The world of a drive with the true and the estimated paths, and the errors of the poses along
 * the way: the paper's Figs. 3 and 4, (a) to (c). */
Figure pathFigure(const Drive& drive, const std::vector<MethodRun>& runs);

/** The segments of a method's reference scans, overlaid as matched and as odometry alone would have
 * them: the paper's Figs. 3 and 4, (d) and (e). */
Figure mapFigure(const Drive& drive, const MethodRun& run, const MatcherOptions& options);
}  // namespace psmks
