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
  if (psm.T_ref_cur.isFinite()) result.T_ref_cur = psm.T_ref_cur;
  if (psm.usable()) result.covariance = psm.covariance;
  settleCovariance(guess, result);
  result.score = std::min(1.0, static_cast<double>(psm.pairs) / std::max(1, goodRays));
  result.associations = psm.pairs;
  result.iterations = psm.iterations;
  return result;
}

/** The original polar scan matching.
 *
 * `score` is the share of the good rays of the current scan that were paired in the last
 * translation step. `times.segmentation_s` is the time of filtering and segmenting,
 * `times.refinement_s` the time of everything else. */
class PsmPairMatcher : public PairMatcher
{
 public:
  explicit PsmPairMatcher(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    Stopwatch stopwatch;
    preparePsmScan(reference, matcher_.options(), reference_);
    preparePsmScan(current, matcher_.options(), current_);
    const double segmentation_s = stopwatch.lap_s();
    MatchResult result = matchPsm(reference_, current_, guess);
    result.times.segmentation_s = segmentation_s;
    return result;
  }

  std::unique_ptr<PreparedScan> prepare(const Scan& scan, const ScannerNoise&) override
  {
    PsmScan prepared;
    preparePsmScan(scan, matcher_.options(), prepared);
    return std::make_unique<PreparedAs<PsmScan>>(std::move(prepared));
  }

  MatchResult matchPrepared(const PreparedScan& reference, const PreparedScan& current,
                            const Guess& guess, SearchScope) override
  {
    return matchPsm(dataOf<PsmScan>(reference), dataOf<PsmScan>(current), guess);
  }

 private:
  MatchResult matchPsm(const PsmScan& reference, const PsmScan& current, const Guess& guess)
  {
    Stopwatch stopwatch;
    const PsmResult psm = matcher_.match(reference, current, guess.T_ref_cur);
    MatchResult result = toMatchResult(psm, guess, current.goodRays());
    result.times.refinement_s = stopwatch.lap_s();
    return result;
  }

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
