/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/pairs/PairsInput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark map-pairs SET...`, which makes a map of each scan of a pair, of
 * points or of cells, and aligns the maps by AlignPDF() of psmks and of MRPT's ICP from the
 * odometry. */
class MapPairsCommand
{
 public:
  explicit MapPairsCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  Table tableOf(const PairsInput& input, const ScanMatcherOptions& options) const;

  std::vector<std::string> sets_;
  PairsChoice choice_;
  double cell_m_ = 0.05;
  double certainty_ = 0.65;
  OptionFlags optionFlags_;
  TableOutput output_;
};
}  // namespace psmks
