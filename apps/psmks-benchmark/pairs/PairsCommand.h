/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/pairs/PairsBenchmark.h>
#include <apps/psmks-benchmark/pairs/PairsInput.h>
#include <apps/psmks-benchmark/pairs/PairsOutput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark pairs SET...`, which runs matchers on sets of scan pairs. A set is
 * a file, or the name of one to be generated. There is a table for each set, and one over all sets
 * without moving objects. */
class PairsCommand
{
 public:
  explicit PairsCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  void addInputFlags(CLI::App& app);
  void addMatchFlags(CLI::App& app);
  void requireInput() const;
  void match(const PairsInput& input);
  std::vector<Guesses> guesses(const std::vector<ScanPair>& pairs) const;
  std::vector<Panel> convergence(const std::vector<ScanPair>& pairs) const;
  std::vector<Table> tables() const;

  std::vector<std::string> sets_;
  bool listsSets_ = false;
  PairsChoice choice_;
  std::string saveFolder_;
  double rangeSigma_m_ = 0;  //!< 0 = that of the set
  std::vector<std::string> guesses_{kZeroGuess, kOdometryGuess};
  double odometrySigma_m_ = 0.07;
  double odometrySigma_deg_ = 8;
  int convergencePairs_ = 20;
  OptionFlags optionFlags_;
  PairsBenchmarkOptions options_;
  PairsOutput output_;
};
}  // namespace psmks
