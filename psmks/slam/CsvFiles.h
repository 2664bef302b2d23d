/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <iosfwd>

namespace psmks
{
/** Writes one row for each match that was tried to place a scan, in the order they were tried: the
 * stamps of both scans, the status, the pose of the robot seen from the robot at the reference, its
 * covariance, how many rays were associated, how long it took, what MatchResult says of the pose,
 * and whether this is the match that decided where the scan is (1) or another one was (0).
 * Covariance terms are in metres and degrees, in the axes of the reference; headers name all units.
 *
 * The columns direction_open, direction_weak, heading_open and guess_given_up are 0 or 1 for
 * unobservableDirection, weakDirection, headingUnobservable and guessGivenUp. The column
 * alternatives counts those of the ambiguity. The innovation is 0 with 0 degrees of freedom where
 * there is none. */
void writeMatchesCsv(std::ostream& out, const std::vector<PosedScan>& scans);

/** Writes one row for each segment of the map, in the frame of the world. */
void writeSegmentsCsv(std::ostream& out, const ScanMap& map);
}  // namespace psmks
