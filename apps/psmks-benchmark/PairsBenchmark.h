/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>

#include <functional>
#include <string>
#include <vector>

namespace psmks
{
/** Where the matches of a pair start. */
enum class GuessKind
{
  Zero,     //!< no motion, without covariance: a starting point and nothing more
  Odometry  //!< the odometry of the file, with a covariance: a measurement
};

/** "zero" or "odometry". */
std::string toString(GuessKind kind);

struct PairsBenchmarkOptions
{
  std::vector<std::string> matchers;
  std::vector<GuessKind> guesses{GuessKind::Zero, GuessKind::Odometry};
  MatcherOptions matcherOptions;
  int repeats = 1;
  bool sequential = false;  //!< also time matches against a reference that is prepared beforehand
  double odometrySigma_m = 0.07;
  double odometrySigma_rad = degToRad(8);
};

/** Every matcher on every pair from every guess.
 *
 * Interleaved, so that a machine that is busy for a while does not favour one matcher: for each
 * repeat, for each guess, for each pair, each matcher in turn. The time of a pair is the smallest
 * of its repeats, from the raw scans to the result. Before the first repeat each matcher matches
 * one pair untimed.
 *
 * @param progress called after each pair with the share that is done, 0 to 1
 * @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<PairsRun> runPairs(const std::vector<ScanPair>& pairs,
                               const PairsBenchmarkOptions& options,
                               const std::function<void(double)>& progress);
}  // namespace psmks
