/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/TableFiles.h>

#include <CLI/CLI.hpp>
#include <vector>

namespace psmks
{
/** Where the tables of a command go: to the terminal and to files, with the machine that they were
 * measured on. */
class TableOutput
{
 public:
  void addFlags(CLI::App& command) { files_.addFlags(command); }

  /** Creates the files, so that a mistyped path is reported before the work is done. */
  void open() { files_.open(); }

  /** To the terminal and to the files.
   *  @param tables all with the same columns */
  void write(const std::vector<Table>& tables);

  /** To the terminal, after the machine. */
  static void print(const std::vector<Table>& tables);

  /** To the files.
   *  @param tables all with the same columns */
  void save(const std::vector<Table>& tables);

 private:
  TableFiles files_;
};
}  // namespace psmks
