/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/RunTimes.h>
#include <apps/support/SlamOptions.h>
#include <apps/support/Summary.h>
#include <psmks/eval/RelationStatistics.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Everything that the summary of a run says. */
struct RunSummary
{
  Summary trajectory;
  std::optional<RelationStatistics> relations;  //!< errors if there are relations
  std::vector<std::string> remarks;             //!< remarks on the log, see LogReader
  RunTimes times;

  double scansPerSecond() const;
};

/** Prints the summary for people. */
void printSummary(std::ostream& out, const RunSummary& summary);

/** Writes the summary for programs, with all options and versions that produced it. */
void writeSummaryJson(std::ostream& out, const RunSummary& summary, SlamOptions& options);
}  // namespace psmks
