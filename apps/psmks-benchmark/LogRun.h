/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/LogScan.h>
#include <apps/support/SlamOptions.h>
#include <apps/support/Summary.h>
#include <psmks/eval/Table.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** A log that every matcher is run on. */
struct Log
{
  std::string title;
  std::vector<LogScan> scans;
  std::optional<Trajectory> groundTruth;
};

/** What a matcher made of a log with one choice of reference scans. */
struct LogRun
{
  std::string matcher;
  std::string reference;  //!< "sequential", "keyframe" or "map"
  Summary summary;
  double time_s = std::numeric_limits<double>::infinity();  //!< of the run, but for reading the log
};

/** Builds the trajectory of a log. Every matcher starts a match where its own trajectory and the
 * odometry of the log lead.
 *  @param reference as in LogRun
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
LogRun runLog(const Log& log, const std::string& matcher, const std::string& reference,
              SlamOptions options);

/** A row for each run. */
Table logTable(const std::string& title, const std::vector<LogRun>& runs);
}  // namespace psmks
