/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/logs/LogPairsBenchmark.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <vector>

namespace psmks
{
/** `psmks-benchmark selfmatch LOG...`: each scan of a log against itself, from a guess that is
 * wrong at random. Reference and current scan being exact copies, the error is the matcher's own.
 */
class SelfmatchCommand
{
 public:
  explicit SelfmatchCommand(CLI::App& app);

  /** As LogPairsBenchmark::run(). */
  ExitCode run();

 private:
  LogPairs pairs(const Log& log) const;

  LogPairsBenchmark benchmark_;
  double displacement_m_ = 0.5;
  double rotation_deg_ = 45;
  unsigned seed_ = 1;
};
}  // namespace psmks
