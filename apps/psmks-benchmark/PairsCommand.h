/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/PairsBenchmark.h>
#include <apps/psmks-benchmark/PairsInput.h>
#include <apps/psmks-benchmark/PairsSetResult.h>
#include <apps/psmks-benchmark/TableOutput.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** `psmks-benchmark pairs SET...`: matchers on scan pairs, one table a set, which is a file or the
 * name of one to be generated, and one over all sets without moving objects. */
class PairsCommand
{
 public:
  explicit PairsCommand(CLI::App& app);

  /** @return the program's exit code
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  int run();

 private:
  void addInputFlags(CLI::App& app);
  void addMatchFlags(CLI::App& app);
  void requireInput() const;
  void settleOptions();
  MatcherOptions matcherOptions() const;
  PairsInput input(const std::string& argument);
  void match(const PairsInput& input);
  void countMatches(const PairsRun& run);
  std::vector<Table> tables() const;
  void write(const std::vector<Table>& tables);

  std::vector<std::string> sets_;
  bool listsSets_ = false;
  unsigned seed_ = 1;
  int generatedPairs_ = 200;
  std::string saveFolder_;
  double rangeSigma_m_ = 0;  //!< 0 = the set's own
  std::vector<std::string> guesses_{"zero", "odometry"};
  std::string configPath_;
  std::vector<std::string> assignments_;
  std::string dumpPath_, htmlPath_;
  int maxPairs_ = 0;
  double odometrySigma_deg_ = 8;
  PairsBenchmarkOptions options_;
  TableOutput output_;

  std::vector<PairsSetResult> results_;
  std::ofstream dump_, html_;
  bool damaged_ = false;
  std::size_t matches_ = 0, usableMatches_ = 0;
};
}  // namespace psmks
