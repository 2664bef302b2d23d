/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>

namespace psmks
{
/** The command `psmks-benchmark maps LOG...`, which follows a robot as MRPT's map builders do:
 * every scan is aligned by AlignPDF() of a map alignment algorithm to a point map that grows. */
class MapsCommand
{
 public:
  explicit MapsCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  LogInput input_;
  OptionFlags optionFlags_;
  TableOutput output_;
  double insertDistance_m_ = 1;
  double insertAngle_deg_ = 30;
};
}  // namespace psmks
