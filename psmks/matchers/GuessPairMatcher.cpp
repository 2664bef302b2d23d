/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/matchers/PairMatcherRegistration.h>

namespace psmks
{
namespace
{
/** Returns the guess as its answer, for comparison: a match has to improve on it. */
class GuessPairMatcher : public PairMatcher
{
 public:
  explicit GuessPairMatcher(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }

  MatchResult match(const Scan&, const Scan&, const Guess& guess) override
  {
    return keptGuess(MatchStatus::Converged, guess);
  }

 private:
  std::string name_;
};

const PairMatcherRegistration kRegistration({"guess", "no match: the guess is the answer",
                                             PairMatcherFamily::Guess, 0,
                                             [](const std::string& name, const MatcherOptions&)
                                             { return std::make_unique<GuessPairMatcher>(name); }});
}  // namespace
}  // namespace psmks
