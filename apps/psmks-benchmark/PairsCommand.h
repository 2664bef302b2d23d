/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/PairsBenchmark.h>
#include <apps/psmks-benchmark/TableOutput.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** `psmks-benchmark pairs FILE...`: matchers on files of scan pairs, one table a file. */
class PairsCommand
{
 public:
  explicit PairsCommand(CLI::App& app);

  /** @return the program's exit code
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  int run();

 private:
  MatcherOptions matcherOptions() const;
  std::vector<ScanPair> readPairs(const std::string& path);
  void match(const std::string& path);
  void countMatches(const PairsRun& run);

  std::vector<std::string> paths_;
  std::vector<std::string> guesses_{"zero", "odometry"};
  std::string configPath_;
  std::vector<std::string> assignments_;
  std::string dumpPath_;
  int maxPairs_ = 0;
  double odometrySigma_deg_ = 8;
  PairsBenchmarkOptions options_;
  TableOutput output_;

  std::vector<Table> tables_;
  std::ofstream dump_;
  bool damaged_ = false;
  std::size_t matches_ = 0, usableMatches_ = 0;
};
}  // namespace psmks
