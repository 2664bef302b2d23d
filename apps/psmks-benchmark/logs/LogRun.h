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
/** The result of a matcher on a log with one policy of reference scans. */
struct LogRun
{
  std::string matcher;
  std::string reference;  //!< "sequential", "keyframe" or "map"
  Summary summary;
  PairErrorStatistics relations;       //!< errors in all relations of the log
  PairErrorStatistics shortRelations;  //!< errors in those that span less than kShortSpan_s
  std::optional<int> jumps;  //!< see countJumps(), between consecutive matched scans or in short
                             //!< relations; nothing if the truth of neither is known
  DrawnRun worst;            //!< motions of the path that are farthest from the truth
  double time_s = std::numeric_limits<double>::infinity();  //!< of the run, without reading the log
  double segmentation_s = 0;  //!< the part of it that segmentation takes
};

/** Builds the trajectory of a log. The guess of a match comes from the trajectory of the same
 * matcher and the odometry of the log.
 *  @param reference as in LogRun
 *  @param drawn number of motions that are kept for drawings
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
LogRun runLog(const Log& log, const std::string& matcher, const std::string& reference,
              SlamOptions options, std::size_t drawn);

/** The table of a log, with a row for each run. */
Table logTable(const std::string& title, const std::vector<LogRun>& runs);
}  // namespace psmks
