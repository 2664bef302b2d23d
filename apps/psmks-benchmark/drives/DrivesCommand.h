/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>

namespace psmks
{
/** The command `psmks-benchmark drives`, which follows simulated robots for long: errors, wrong
 * links, time and memory. */
class DrivesCommand
{
 public:
  explicit DrivesCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  std::string world_ = "kilometres";
  unsigned firstSeed_ = 1;
  unsigned seeds_ = 1;
  double minutes_ = 1440;
  int people_ = 0;
  bool showTenths_ = false;
  OptionFlags optionFlags_;
  TableOutput output_;
};
}  // namespace psmks
