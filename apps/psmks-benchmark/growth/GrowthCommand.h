/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/growth/GrowthRun.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>

namespace psmks
{
/** The command `psmks-benchmark growth`, which measures how the time of a match grows with the
 * number of rays. */
class GrowthCommand
{
 public:
  explicit GrowthCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  GrowthOptions options_;
  std::string plotPath_;
  TableOutput output_;
};
}  // namespace psmks
