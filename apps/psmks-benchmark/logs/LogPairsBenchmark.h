/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <apps/psmks-benchmark/pairs/PairsBenchmark.h>
#include <apps/psmks-benchmark/pairs/PairsOutput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace psmks
{
/** Pairs of scans of a log with their guesses. */
struct LogPairs
{
  std::string title;
  std::vector<ScanPair> pairs;
  std::vector<Guesses> guesses;
};

/** The common part of the commands that match pairs of scans of logs: it runs all matchers on all
 * pairs and makes a table for each set of pairs. */
class LogPairsBenchmark
{
 public:
  using MakePairs =
      std::function<std::vector<LogPairs>(const Log& log, const SlamOptions& options)>;

  /** @param success default limit of the errors of a success */
  LogPairsBenchmark(CLI::App& app, const PairError& success);

  LogInput& input() { return input_; }

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted
   *  @throws ProgramError if a truth cannot be read */
  ExitCode run(const MakePairs& makePairs);

 private:
  void match(const LogPairs& set);

  LogInput input_;
  OptionFlags optionFlags_;
  double success_m_, success_deg_;
  PairsBenchmarkOptions options_;
  PairsOutput output_;
};
}  // namespace psmks
