/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <psmks/psm/PsmMatcher.h>

#include <algorithm>

namespace psmks
{
namespace
{
MatchStatus toMatchStatus(PsmStatus status)
{
  switch (status)
  {
    case PsmStatus::NotRun:
      return MatchStatus::NotRun;
    case PsmStatus::Converged:
      return MatchStatus::Converged;
    case PsmStatus::MaxIterations:
      return MatchStatus::MaxIterations;
    case PsmStatus::TooFewPairs:
      return MatchStatus::TooFewAssociations;
    case PsmStatus::Singular:
      return MatchStatus::NoImprovement;
    case PsmStatus::InvalidInput:
      break;
  }
  return MatchStatus::InvalidInput;
}

MatchResult toMatchResult(const PsmResult& psm, const Guess& guess, int goodRays)
{
  MatchResult result = keptGuess(toMatchStatus(psm.status), guess);
  result.T_ref_cur = psm.T_ref_cur;
  if (psm.usable()) result.covariance = psm.covariance;
  result.score = std::min(1.0, static_cast<double>(psm.pairs) / std::max(1, goodRays));
  result.associations = psm.pairs;
  result.iterations = psm.iterations;
  return result;
}
/** The original polar scan matching, on equal terms.
 *
 *  `score` is the share of the current scan's good rays that paired in the last translation step;
 *  times.segmentation_s is the time of filtering and segmenting, times.refinement_s all the rest.
 */
class PsmPairMatcher : public PairMatcher
{
 public:
  explicit PsmPairMatcher(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    Stopwatch stopwatch;
    setReference(reference);
    const double reference_s = stopwatch.lap_s();
    MatchResult result = matchToReference(current, guess, SearchScope::Full);
    result.times.segmentation_s += reference_s;
    return result;
  }

  void setReference(const Scan& reference) override
  {
    preparePsmScan(reference, matcher_.options(), reference_);
  }

  MatchResult matchToReference(const Scan& current, const Guess& guess,
                               SearchScope /*scope*/) override
  {
    Stopwatch stopwatch;
    preparePsmScan(current, matcher_.options(), current_);
    const double segmentation_s = stopwatch.lap_s();

    const PsmResult psm = matcher_.match(reference_, current_, guess.T_ref_cur);
    MatchResult result = toMatchResult(psm, guess, current_.goodRays());
    result.times.segmentation_s = segmentation_s;
    result.times.refinement_s = stopwatch.lap_s();
    return result;
  }

 private:
  std::string name_;
  PsmMatcher matcher_;
  PsmScan reference_, current_;
};

const PairMatcherRegistration kRegistration(
    {"psm", "the original polar scan matching of Diosi and Kleeman", PairMatcherFamily::Psm, 0,
     [](const std::string& name, const MatcherOptions&)
     { return std::make_unique<PsmPairMatcher>(name); }});
}  // namespace
}  // namespace psmks
