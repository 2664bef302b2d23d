/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/ExternalSolvers.h>
#include <psmks/core/Guess.h>
#include <psmks/core/LinePairing.h>
#include <psmks/core/MatchResult.h>
#include <psmks/core/MatchTrace.h>
#include <psmks/core/PaperCovariance.h>
#include <psmks/core/PaperOptions.h>
#include <psmks/core/PoseObjective.h>
#include <psmks/core/TranslationRegression.h>

namespace psmks
{
/** The buffers of a match by the paper's scheme, kept from one to the next. */
struct PaperBuffers
{
  PoseObjective objective;
  TranslationProblem translation;
  PaperCovariance covariance;
  MatchView reference, current;  //!< for the free-space score
};

/** Matches two scans by the scheme of the paper (section 2.3):
 *
 *  1. Orientation search at the present translation.
 *  2. Translation regression at the new orientation.
 *  3. The update is accepted only if the matching error falls; else the step is
 *     halved a few times, and if nothing helps the search ends.
 *  4. Again from 1, until the steps are small or the iterations run out.
 *
 * Differs from the paper: that rejects a step at once (stepHalvings = 0). Its Jacobian asks for
 * steps up to twice too long, and many matches then end on their first alternation.
 *
 * Bad data never throws, see MatchStatus.
 *
 * @param external null unless options.translationSolver is Ceres
 * @param trace may be null */
MatchResult matchByPaperScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, const PaperOptions& options,
                               const ExternalSolvers* external, PaperBuffers& buffers,
                               MatchTrace* trace);
}  // namespace psmks
