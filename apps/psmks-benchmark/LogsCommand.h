/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/LogRun.h>
#include <apps/psmks-benchmark/TableOutput.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace psmks
{
/** `psmks-benchmark logs LOG...`: every matcher with every choice of reference scans on the same
 * logs, one table a log. */
class LogsCommand
{
 public:
  explicit LogsCommand(CLI::App& app);

  /** @return the program's exit code
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted; ProgramError
   * for a ground truth that cannot be read */
  int run();

 private:
  using Method = std::pair<std::string, std::string>;  //!< matcher and reference

  void setOptions();
  std::vector<Log> readLogs();
  Log readLog(const std::string& path);
  std::optional<std::string> groundTruthOf(const std::string& log) const;
  std::vector<LogRun> runs(const Log& log);
  std::vector<Method> chosenMethods() const;

  std::vector<std::string> paths_;
  std::vector<std::string> matchers_;
  std::vector<std::string> references_{"sequential", "keyframe", "map"};
  std::string groundTruth_;
  std::string configPath_;
  std::vector<std::string> assignments_;
  int maxScans_ = 0;
  int repeats_ = 1;
  SlamOptions options_;
  TableOutput output_;
  bool damaged_ = false;
};
}  // namespace psmks
