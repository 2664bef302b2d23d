/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/mrpt/PairMatcher.h>

namespace psmks
{
/** Takes the guess for the answer: what matching has to improve on. */
class GuessPairMatcher : public PairMatcher
{
 public:
  explicit GuessPairMatcher(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }

  MatchResult match(const Scan&, const Scan&, const Guess& guess) override
  {
    MatchResult result;
    result.status = MatchStatus::Converged;
    result.T_ref_cur = guess.T_ref_cur;
    if (guess.covariance) result.covariance = *guess.covariance;
    return result;
  }

 private:
  std::string name_;
};
}  // namespace psmks
