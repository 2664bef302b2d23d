/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/growth/GrowthRun.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>

namespace psmks
{
/** `psmks-benchmark growth`: how the time of a match grows with the rays of the scans. */
class GrowthCommand
{
 public:
  explicit GrowthCommand(CLI::App& app);

  /** @return the program's exit code
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  GrowthOptions options_;
  std::string plotPath_;
  TableOutput output_;
};
}  // namespace psmks
