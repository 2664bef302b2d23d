/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/PsmksPairMatcher.h>

#include <chrono>

namespace psmks
{
PsmksPairMatcher::PsmksPairMatcher(std::string name, MatcherOptions options)
    : name_(std::move(name)), matcher_(std::move(options))
{
}

MatchResult PsmksPairMatcher::match(const Scan& reference, const Scan& current, const Guess& guess)
{
  return matcher_.match(reference, current, guess, workspace_);
}

void PsmksPairMatcher::setReference(const Scan& reference)
{
  matcher_.segment(reference, reference_);
}

MatchResult PsmksPairMatcher::matchToReference(const Scan& current, const Guess& guess)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  matcher_.segment(current, current_);
  const std::chrono::duration<double> segmentation = Clock::now() - start;

  MatchResult result = matcher_.match(reference_, current_, guess, workspace_);
  result.times.segmentation_s += segmentation.count();
  return result;
}
}  // namespace psmks
