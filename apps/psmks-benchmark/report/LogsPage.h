/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/report/HtmlPage.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>
#include <psmks/eval/Table.h>

#include <string>
#include <vector>

namespace psmks
{
/** Pairs of scans of a run on a log that are drawn on a page. */
struct DrawnRun
{
  std::string title;
  std::vector<ScanPair> pairs;
  /** One for each pair; the id is the index of the scan in the log. */
  std::vector<PairRecord> records;
};

/** The comparison of matchers on logs as an HTML page: the tables, and folded the drawings of each
 * run. */
std::string logsPage(const PageOrigin& origin, const std::vector<Table>& tables,
                     const std::vector<DrawnRun>& runs);
}  // namespace psmks
