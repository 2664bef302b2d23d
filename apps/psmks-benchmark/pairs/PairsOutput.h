/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/pairs/PairsSetResult.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <string>
#include <vector>

namespace psmks
{
/** Collects the results of matchers on sets of pairs and writes them as tables, as a CSV file of
 * all matches, and as an HTML page. */
class PairsOutput
{
 public:
  void addFlags(CLI::App& command);

  /** Creates the files now, so that a mistyped path is reported before the work is done. */
  void open();

  /** Writes the matches of a set to the CSV file, and keeps the set for write(). */
  void add(PairsSetResult result);

  const std::vector<PairsSetResult>& results() const { return results_; }

  bool hasPage() const { return html_.is_open(); }

  /** The tables, one for each set. */
  std::vector<Table> tables() const;

  /** Writes the tables and the page; nothing without tables.
   *  @param tables those of tables(), and further ones with the same columns */
  void write(const std::vector<Table>& tables);

  /** The exit code of the program.
   *  @param damaged whether a part of the input could not be read */
  ExitCode exitCode(bool damaged) const;

 private:
  bool everyMatchFailed() const;

  std::string dumpPath_, htmlPath_;
  std::ofstream dump_, html_;
  TableOutput tables_;
  std::vector<PairsSetResult> results_;
};
}  // namespace psmks
