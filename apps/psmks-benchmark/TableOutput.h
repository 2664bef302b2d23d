/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/TableFiles.h>

#include <CLI/CLI.hpp>
#include <vector>

namespace psmks
{
/** The output of the tables of a command: the terminal and files. The machine on which times were
 * measured is part of it. */
class TableOutput
{
 public:
  void addFlags(CLI::App& command) { files_.addFlags(command); }

  /** Checks the paths of the files, so that a mistyped one is reported before the work is done. */
  void check() const { files_.check(); }

  /** Writes tables to the terminal and to the files.
   *  @param tables all with the same columns */
  void write(const std::vector<Table>& tables);

  /** Prints the machine and the tables. */
  static void print(const std::vector<Table>& tables);

  /** Writes tables to the files.
   *  @param tables all with the same columns */
  void save(const std::vector<Table>& tables);

 private:
  TableFiles files_;
};
}  // namespace psmks
