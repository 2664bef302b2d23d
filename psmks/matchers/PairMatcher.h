/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/Scan.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/SearchScope.h>

#include <memory>
#include <string>
#include <vector>

namespace psmks
{
/** Any method that estimates the motion between two scans: psmks' own schemes and the ones they are
 *  compared with. Owns its buffers, so one object serves one thread. */
class PairMatcher
{
 public:
  virtual ~PairMatcher() = default;

  /** The name it was made by. */
  virtual std::string name() const = 0;

  /** Pose of the current scan in the frame of the reference scan. Everything the method does with
   * the raw scans happens in here. Bad data never throws: see MatchStatus. */
  virtual MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) = 0;

  /** Keeps a reference for the calls of matchToReference() that follow. */
  virtual void setReference(const Scan& reference) { reference_ = reference; }

  /** As match() against the last reference that was set, whose preparation is not repeated. The
   * scans are those of one scanner: a method may learn of its noise.
   *  @param scope how far from the guess psmks' joint scheme looks; other methods have but one */
  virtual MatchResult matchToReference(const Scan& current, const Guess& guess,
                                       [[maybe_unused]] SearchScope scope = SearchScope::Full)
  {
    return match(reference_, current, guess);
  }

 private:
  Scan reference_;
};

/** The result that stays at the guess, with the covariance of the guess where it has one: what a
 * match that failed gives. */
MatchResult keptGuess(MatchStatus status, const Guess& guess);

/** The names that makePairMatcher() knows, in the order of listings. Each matcher registers itself
 *  in its own file, see PairMatcherRegistration.h. */
std::vector<std::string> pairMatcherNames();

/** A matcher by its name, among them `psmks`, these options, and `guess`, no match at all: the
 * guess is the answer. `psmks-benchmark matchers` lists them all.
 *
 *  @throws OptionError naming the known ones for any other name, and where the options choose a
 * solver that was not built */
std::unique_ptr<PairMatcher> makePairMatcher(const std::string& name,
                                             const MatcherOptions& options = {});
}  // namespace psmks
