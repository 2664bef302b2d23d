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
  bool sequential = false;    //!< also time matches against a reference that is prepared beforehand
  bool ofOneScanner = false;  //!< the scans are those of one scanner, as in a log: what the pairs
                              //!< before have shown of its noise counts for the next
};

/** Every matcher on every pair from every kind of guess.
 *
 * Interleaved, so that a machine that is busy for a while does not favour one matcher: for each
 * repeat, for each kind of guess, for each pair, each matcher in turn. The time of a pair is the
 * smallest of its repeats, from the raw scans to the result. Before the first repeat each matcher
 * matches one pair untimed.
 *
 * @param progress called after each pair with the share that is done, 0 to 1
 * @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<PairsRun> runPairs(const std::vector<ScanPair>& pairs,
                               const std::vector<Guesses>& guesses,
                               const PairsBenchmarkOptions& options,
                               const std::function<void(double)>& progress);
}  // namespace psmks
