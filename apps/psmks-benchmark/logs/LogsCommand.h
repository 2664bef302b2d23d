/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/psmks-benchmark/logs/LogRun.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark logs LOG...`, which runs all matchers with all policies of
 * reference scans on logs and makes a table for each log. */
class LogsCommand
{
 public:
  explicit LogsCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted
   *  @throws ProgramError if a truth cannot be read */
  ExitCode run();

 private:
  using Method = std::pair<std::string, std::string>;  //!< matcher and reference

  std::vector<LogRun> runs(const Log& log);
  void write(const std::vector<Table>& tables, const std::vector<LogRun>& runs);
  std::vector<Method> chosenMethods() const;

  LogInput input_;
  std::vector<std::string> matchers_{"psmks",   "psmks-paper", "psm",
                                     kBaseline, "icp-lm",      kNoMatcher};
  std::vector<std::string> references_{"sequential", "keyframe", "map"};
  int repeats_ = 1;
  OptionFlags optionFlags_;
  SlamOptions options_;
  TableOutput output_;
  std::string htmlPath_;
  std::size_t drawn_ = 10;
};
}  // namespace psmks
