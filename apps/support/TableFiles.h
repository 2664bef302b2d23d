/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Table.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace psmks
{
/** Opens a file for writing.
 *  @throws CLI::ValidationError naming the flag where it cannot be created */
std::ofstream createFile(const std::string& flag, const std::string& path);

/** What the numbers of tables depend on besides the input. */
struct TableOrigin
{
  std::string key;   //!< for programs: "machine"
  std::string line;  //!< for people
  std::vector<std::pair<std::string, std::string>> fields;
};

/** The files into which a program writes its tables. */
class TableFiles
{
 public:
  /** --csv, --json and --markdown */
  void addFlags(CLI::App& command);

  /** Creates the files, so that a mistyped path is reported before the work is done.
   *  @throws CLI::ValidationError naming the flag */
  void open();

  /** @param tables all with the same columns
   *  @param origin null where the input alone counts */
  void save(const std::vector<Table>& tables, const TableOrigin* origin = nullptr);

 private:
  std::string csvPath_, jsonPath_, markdownPath_;
  std::ofstream csv_, json_, markdown_;
};
}  // namespace psmks
