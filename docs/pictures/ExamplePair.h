/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Matcher.h>
#include <psmks/eval/Chart.h>

#include <string>

namespace psmks
{
/** Two scans, segmented and matched. */
struct ExamplePair
{
  SegmentedScan reference, current;
  Guess guess;
  MatchResult result;
};

/** The two scans of an office building that come with MRPT, 0.8 m and 9 degrees apart, matched from
 * a guess of 0.8 m straight ahead. */
ExamplePair stockPair();

/** Two scans of a log, matched from no motion.
 *  @param reference, current numbers of scans, counted from 0 */
ExamplePair pairOfLog(const std::string& log, int reference, int current);

/** Two scans computed for a straight corridor without doors, 2 m wide, seen 8 m far, and matched
 * from no motion: the scanner has moved by 0.4 m along the corridor, 0.2 m across it, and 5
 * degrees. The position along it cannot be known from them. */
ExamplePair bareCorridorPair();

/** The end points of the valid rays, moved by a pose. */
ChartSeries rayPoints(const std::string& name, const SegmentedScan& scan, const Pose2& T_ref_scan,
                      unsigned rgb);

/** The segments from end to end, moved by a pose. */
ChartSeries segmentLines(const std::string& name, const SegmentedScan& scan,
                         const Pose2& T_ref_scan, unsigned rgb);

/** A triangle that points where a scanner looks. */
ChartSeries scannerMark(const std::string& name, const Pose2& T_ref_scanner, double length_m,
                        unsigned rgb);

/** A chart in metres, in the frame of the reference scan. */
Chart planChart(const std::string& title);
}  // namespace psmks
