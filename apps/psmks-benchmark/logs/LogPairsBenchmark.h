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
/** Pairs of scans of a log, with where their matches start. */
struct LogPairs
{
  std::string title;
  std::vector<ScanPair> pairs;
  std::vector<Guesses> guesses;
};

/** What the commands that match pairs of scans of logs have in common: every matcher on every pair,
 *  a table for each set of pairs. */
class LogPairsBenchmark
{
 public:
  using MakePairs =
      std::function<std::vector<LogPairs>(const Log& log, const SlamOptions& options)>;

  /** @param success what a success may be off by where no flag says so */
  LogPairsBenchmark(CLI::App& app, const PairError& success);

  LogInput& input() { return input_; }

  /** @return the program's exit code
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted; and as
   * LogInput::read() */
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
