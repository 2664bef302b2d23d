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
/** What there is to say of a run. */
struct RunSummary
{
  Summary trajectory;
  std::optional<RelationStatistics> relations;  //!< errors, where relations were given
  std::vector<std::string> remarks;             //!< on the log, see LogReader
  RunTimes times;

  double scansPerSecond() const;
};

/** For people. */
void printSummary(std::ostream& out, const RunSummary& summary);

/** For programs: everything, with the options and the versions it was made by. */
void writeSummaryJson(std::ostream& out, const RunSummary& summary, SlamOptions& options);
}  // namespace psmks
