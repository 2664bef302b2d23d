/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/psmks-benchmark/report/LogsPage.h>
#include <apps/support/SlamOptions.h>
#include <apps/support/Summary.h>
#include <psmks/eval/RelationStatistics.h>
#include <psmks/eval/Table.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What a matcher made of a log with one choice of reference scans. */
struct LogRun
{
  std::string matcher;
  std::string reference;  //!< "sequential", "keyframe" or "map"
  Summary summary;
  PairErrorStatistics relations;       //!< errors over all relations of the log
  PairErrorStatistics shortRelations;  //!< over those that span less than kShortSpan_s
  std::optional<int> jumps;  //!< see countJumps(); from matched scan to matched scan, or over short
                             //!< relations; none where neither is known
  DrawnRun worst;            //!< where its path is furthest from the truth, as jumps are counted
  double time_s = std::numeric_limits<double>::infinity();  //!< of the run, but for reading the log
  double segmentation_s = 0;                                //!< of that, in segmenting scans
};

/** Builds the trajectory of a log. Every matcher starts a match where its own trajectory and the
 * odometry of the log lead.
 *  @param reference as in LogRun
 *  @param drawn motions that are kept for drawing
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
LogRun runLog(const Log& log, const std::string& matcher, const std::string& reference,
              SlamOptions options, std::size_t drawn);

/** A row for each run. */
Table logTable(const std::string& title, const std::vector<LogRun>& runs);
}  // namespace psmks
