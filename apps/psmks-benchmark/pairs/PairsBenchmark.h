/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Guesses.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>

#include <functional>
#include <string>
#include <vector>

namespace psmks
{
struct PairsBenchmarkOptions
{
  std::vector<std::string> matchers;
  MatcherOptions matcherOptions;
  int repeats = 1;
  bool sequential = false;    //!< also measures the time with a reference prepared before
  bool ofOneScanner = false;  //!< the pairs are matched like those of a log, and a matcher may
                              //!< estimate the noise of the scanner from them
};

/** Runs all matchers on all pairs with all kinds of guesses.
 *
 * The order is interleaved so that a machine that is busy for some time does not favour a matcher:
 * for each repeat, for each kind of guess, for each pair, all matchers run in turn. The time of a
 * match is measured from the raw scans to the result, and the smallest one of the repeats counts.
 * Before the first repeat each matcher matches one pair without measurement.
 *
 * The result is empty where a signal asks the program to stop before all are matched.
 *
 * @param progress called after each pair with the share of the work that is done, 0 to 1
 * @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<PairsRun> runPairs(const std::vector<ScanPair>& pairs,
                               const std::vector<Guesses>& guesses,
                               const PairsBenchmarkOptions& options,
                               const std::function<void(double)>& progress);
}  // namespace psmks
