/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <iosfwd>

namespace psmks
{
/** One row a match: where the robot was seen from the reference's, how sure that is, and what it
 * cost. Covariance terms are in metres and degrees, in the axes of the reference. */
void writeMatchesCsv(std::ostream& out, const std::vector<PosedScan>& scans);

/** One row a segment, in the world's frame. */
void writeSegmentsCsv(std::ostream& out, const ScanMap& map);
}  // namespace psmks
