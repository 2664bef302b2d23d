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

  /** Checks the paths of the files, so that a mistyped one is reported before the work is done. */
  void check() const;

  /** Keeps the set for write(). */
  void add(PairsSetResult result) { results_.push_back(std::move(result)); }

  const std::vector<PairsSetResult>& results() const { return results_; }

  bool hasPage() const { return !htmlPath_.empty(); }

  /** The tables, one for each set. */
  std::vector<Table> tables() const;

  /** Writes the tables, the page and the matches of all sets; nothing without tables.
   *  @param tables those of tables(), and further ones with the same columns
   *  @throws ProgramError (kOutputFailed) naming files that cannot be written */
  void write(const std::vector<Table>& tables);

  /** The exit code of the program.
   *  @param damaged whether a part of the input could not be read */
  ExitCode exitCode(bool damaged) const;

 private:
  bool everyMatchFailed() const;
  void dump(std::ostream& csv) const;

  std::string dumpPath_, htmlPath_;
  TableOutput tables_;
  std::vector<PairsSetResult> results_;
};
}  // namespace psmks
