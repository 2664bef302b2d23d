/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Table.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <string>
#include <vector>

namespace psmks
{
/** Opens a file for writing.
 *  @throws CLI::ValidationError naming the flag where it cannot be created */
std::ofstream createFile(const std::string& flag, const std::string& path);

/** Where the tables of a command go besides the terminal. */
class TableOutput
{
 public:
  void addFlags(CLI::App& command);

  /** Creates the files, so that a mistyped path is reported before the work is done. */
  void open();

  /** To the terminal and to the files.
   *  @param tables all with the same columns */
  void write(const std::vector<Table>& tables);

  /** To the terminal, after the machine. */
  static void print(const std::vector<Table>& tables);

  /** To the files.
   *  @param tables all with the same columns */
  void save(const std::vector<Table>& tables);

 private:
  std::string csvPath_, jsonPath_, markdownPath_;
  std::ofstream csv_, json_, markdown_;
};
}  // namespace psmks
