/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Covariance.h>
#include <psmks/match/KeptGuess.h>

namespace psmks
{
Guess boundedGuess(const Guess& guess)
{
  Guess bounded = guess;
  if (guess.covariance) bounded.covariance = boundedCovariance(*guess.covariance);
  return bounded;
}

MatchResult keptGuess(MatchStatus status, const Guess& guess)
{
  MatchResult result;
  result.status = status;
  if (guess.T_ref_cur.isFinite()) result.T_ref_cur = guess.T_ref_cur;
  if (guess.covariance && isCovariance(*guess.covariance))
    result.covariance = boundedCovariance(*guess.covariance);
  return result;
}

void settleCovariance(const Guess& guess, MatchResult& result)
{
  const bool isOne =
      result.covariance.allFinite() && (result.covariance.diagonal().array() > 0).all();
  result.covariance =
      isOne ? boundedCovariance(result.covariance) : keptGuess(result.status, guess).covariance;
}
}  // namespace psmks
