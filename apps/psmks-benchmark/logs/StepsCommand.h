/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/logs/LogPairsBenchmark.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark steps LOG...`, which matches consecutive scans of a log and
 * compares the motions with a true trajectory. */
class StepsCommand
{
 public:
  explicit StepsCommand(CLI::App& app);

  /** See LogPairsBenchmark::run(). */
  ExitCode run();

 private:
  std::vector<LogPairs> pairs(const Log& log, const OdometryOptions& odometry) const;

  LogPairsBenchmark benchmark_;
  std::vector<int> every_{1};
  std::vector<std::string> guesses_{kZeroGuess, kOdometryGuess};
};
}  // namespace psmks
