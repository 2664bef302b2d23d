/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/Scan.h>
#include <psmks/match/Guess.h>
#include <psmks/match/KeptGuess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/SearchScope.h>
#include <psmks/matchers/PreparedScan.h>
#include <psmks/segmentation/ScannerNoise.h>

#include <memory>
#include <string>
#include <vector>

namespace psmks
{
/** Any method that estimates the motion between two scans: the schemes of psmks and the methods
 * that they are compared with.
 *
 * A result depends on the arguments of the call alone, never on the calls before: an object owns
 * buffers, and nothing that it has learnt. One object serves one thread. */
class PairMatcher
{
 public:
  virtual ~PairMatcher() = default;

  /** The name that makePairMatcher() made this matcher by. */
  virtual std::string name() const = 0;

  /** Pose of the current scan in the frame of the reference scan, both taken by themselves: what
   * either shows of its noise is believed.
   *
   * Never throws for bad data: scans without returns, or a guess that is not finite, end in
   * MatchStatus::InvalidInput at the guess, or at the origin where it is not finite. The covariance
   * is symmetric and positive definite for every input (settleCovariance()). The times of the
   * result hold everything that was done with the two raw scans. */
  virtual MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) = 0;

  /** Does once what every match of a scan needs, whether the scan is the reference or the current
   * one. By default that is a copy of the scan. Never throws for bad data.
   *  @param scanner what other scans of the scanner have shown of its noise; with the default, what
   * this scan shows is believed. The caller decides which scans to count in it. */
  virtual std::unique_ptr<PreparedScan> prepare(const Scan& scan, const ScannerNoise& scanner = {});

  /** As match(), of scans that were prepared before. The times of the result leave their
   * preparation out.
   *  @param scope how far from the guess the joint scheme of psmks searches; other methods have one
   * scope only
   *  @throws std::bad_cast where a matcher of another kind has prepared a scan */
  virtual MatchResult matchPrepared(const PreparedScan& reference, const PreparedScan& current,
                                    const Guess& guess, SearchScope scope = SearchScope::Full);
};

/** The names that makePairMatcher() knows, in the order of listings. Each matcher registers itself
 *  in its own file, see PairMatcherRegistration.h. */
std::vector<std::string> pairMatcherNames();

/** Makes a matcher by its name: `psmks` matches by these options, `guess` does not match at all but
 * returns the guess, and `psmks-benchmark matchers` lists all names.
 *
 *  @throws OptionError that lists the known names for any other name, and OptionError where the
 * options choose a solver that was not built */
std::unique_ptr<PairMatcher> makePairMatcher(const std::string& name,
                                             const MatcherOptions& options = {});
}  // namespace psmks
