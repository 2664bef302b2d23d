/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Table.h>

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace psmks
{
/** Checks that a file can be created, so that a mistyped path is reported before the work is done.
 *  @param flag that named the file
 *  @throws CLI::ValidationError naming the flag if the file cannot be created */
void requireCreatable(const std::string& flag, const std::string& path);

/** What the numbers of tables depend on besides the input, such as the machine. */
struct TableOrigin
{
  std::string key;   //!< name for programs, such as "machine"
  std::string line;  //!< text for people
  std::vector<std::pair<std::string, std::string>> fields;
};

/** The files that a program writes its tables to. */
class TableFiles
{
 public:
  /** Adds --csv, --json and --markdown. */
  void addFlags(CLI::App& command);

  /** Checks the paths of the files; see requireCreatable(). */
  void check() const;

  /** Writes tables to all files.
   *  @param tables all with the same columns
   *  @param origin null if the numbers depend on the input alone
   *  @throws ProgramError (kOutputFailed) naming those that cannot be written, after the others
   * were */
  void save(const std::vector<Table>& tables, const TableOrigin* origin = nullptr) const;

 private:
  std::string csvPath_, jsonPath_, markdownPath_;
};
}  // namespace psmks
