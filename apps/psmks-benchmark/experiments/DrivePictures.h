/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/MethodRun.h>
#include <psmks/eval/Figure.h>

#include <vector>

namespace psmks
{
/** The world of a drive with the true and the estimated paths, and the errors of the poses over the
 * distance driven: Figs. 3 and 4, (a) to (c), of the paper. */
Figure pathFigure(const Drive& drive, const std::vector<MethodRun>& runs);

/** The segments of the reference scans of a method, placed by the matches and by odometry alone:
 * Figs. 3 and 4, (d) and (e), of the paper. */
Figure mapFigure(const Drive& drive, const MethodRun& run, const MatcherOptions& options);
}  // namespace psmks
