/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Matcher.h>
#include <psmks/mrpt/PairMatcher.h>

namespace psmks
{
/** psmks::Matcher with a workspace of its own. */
class PsmksPairMatcher : public PairMatcher
{
 public:
  /** @throws OptionError where the options choose a solver that was not built */
  PsmksPairMatcher(std::string name, MatcherOptions options);

  std::string name() const override { return name_; }
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override;
  void setReference(const Scan& reference) override;
  MatchResult matchToReference(const Scan& current, const Guess& guess) override;

 private:
  std::string name_;
  Matcher matcher_;
  MatcherWorkspace workspace_;
  SegmentedScan reference_, current_;
};
}  // namespace psmks
