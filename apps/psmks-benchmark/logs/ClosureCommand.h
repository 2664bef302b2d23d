/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark closure LOG...`, which matches scans a, b and c of a log in a
 * triangle and holds the error of its closure against what the noise of the scans explains. */
class ClosureCommand
{
 public:
  explicit ClosureCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  Table closures(const Log& log, const MatcherOptions& options) const;

  LogInput input_;
  OptionFlags optionFlags_;
  TableOutput output_;
  std::vector<int> apart_ = {1};
  int most_ = 500;
  int draws_ = 30;
  unsigned seed_ = 1;
};
}  // namespace psmks
