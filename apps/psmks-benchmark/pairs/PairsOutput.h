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
/** Gathers what matchers made of sets of pairs and writes it: tables, every match as CSV, and one
 *  page for the browser. */
class PairsOutput
{
 public:
  void addFlags(CLI::App& command);

  /** Creates the files, so that a mistyped path is reported before the work is done. */
  void open();

  /** Dumps its matches and keeps it for write(). */
  void add(PairsSetResult result);

  const std::vector<PairsSetResult>& results() const { return results_; }

  bool hasPage() const { return html_.is_open(); }

  /** One table a set. */
  std::vector<Table> tables() const;

  /** Nothing where there are no tables.
   *  @param tables as from tables(), and more of the same columns */
  void write(const std::vector<Table>& tables);

  /** Of the program.
   *  @param damaged whether some of the input could not be read */
  ExitCode exitCode(bool damaged) const;

 private:
  bool everyMatchFailed() const;

  std::string dumpPath_, htmlPath_;
  std::ofstream dump_, html_;
  TableOutput tables_;
  std::vector<PairsSetResult> results_;
};
}  // namespace psmks
