/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Matcher.h>
#include <psmks/eval/Chart.h>

#include <string>

namespace psmks
{
/** Two scans of a real robot, segmented and matched. */
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
