/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Stopwatch.h>
#include <psmks/mrpt/BuiltSolvers.h>
#include <psmks/mrpt/PsmksPairMatcher.h>

namespace psmks
{
PsmksPairMatcher::PsmksPairMatcher(std::string name, MatcherOptions options)
    : name_(std::move(name)), matcher_(std::move(options), builtSolvers())
{
}

MatchResult PsmksPairMatcher::match(const Scan& reference, const Scan& current, const Guess& guess)
{
  return matcher_.match(reference, current, guess, workspace_);
}

void PsmksPairMatcher::setReference(const Scan& reference)
{
  matcher_.segment(reference, workspace_, reference_);
}

MatchResult PsmksPairMatcher::matchToReference(const Scan& current, const Guess& guess)
{
  Stopwatch stopwatch;
  matcher_.segment(current, workspace_, current_);
  const double segmentation_s = stopwatch.lap_s();

  MatchResult result = matcher_.match(reference_, current_, guess, workspace_);
  result.times.segmentation_s += segmentation_s;
  return result;
}
}  // namespace psmks
