/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/support/ExitCode.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/sim/World.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark segmentation`, which compares the Kalman segmentation of simulated
 * scans with the true walls. */
class SegmentationCommand
{
 public:
  explicit SegmentationCommand(CLI::App& app);

  /** Does the work. */
  ExitCode run();

 private:
  std::vector<Table::Cell> measure(const std::string& worldName, const World& world,
                                   const std::string& filterName, LineFilter filter) const;

  std::string filter_ = "both";
  int poses_ = 2000;
  unsigned seed_ = 1;
  TableOutput output_;
};
}  // namespace psmks
