/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/logs/LogPairsBenchmark.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark selfmatch LOG...`, which matches each scan of a log against itself
 * from a random wrong guess. Both scans are exact copies, so the error is that of the matcher
 * alone. */
class SelfmatchCommand
{
 public:
  explicit SelfmatchCommand(CLI::App& app);

  /** See LogPairsBenchmark::run(). */
  ExitCode run();

 private:
  LogPairs pairs(const Log& log) const;

  LogPairsBenchmark benchmark_;
  double displacement_m_ = 0.5;
  double rotation_deg_ = 45;
  unsigned seed_ = 1;
};
}  // namespace psmks
