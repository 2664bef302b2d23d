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
/** `psmks-benchmark segmentation`: Kalman Segmentation of simulated scans held against the walls
 *  that the rays met. */
class SegmentationCommand
{
 public:
  explicit SegmentationCommand(CLI::App& app);

  /** @return the program's exit code */
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
