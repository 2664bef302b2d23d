/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>

namespace psmks
{
/** A guess with its covariance bounded, see boundedCovariance(): a prior that is vaguer than a
 * kilometre counts as one of a kilometre. */
Guess boundedGuess(const Guess& guess);

/** The result of a match that failed: it stays at the guess, at the origin where the guess is not
 * finite, with the covariance of the guess where it has a valid one, bounded, else with the default
 * of MatchResult. */
MatchResult keptGuess(MatchStatus status, const Guess& guess);

/** Makes the covariance of a result symmetric and positive definite (boundedCovariance()). One that
 * is not finite, or has no positive variance, is replaced by that of keptGuess(). Every matcher
 * ends by it. */
void settleCovariance(const Guess& guess, MatchResult& result);
}  // namespace psmks
