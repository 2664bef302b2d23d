/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/ScanFeatures.h>
#include <psmks/match/ExternalSolvers.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/MatchTrace.h>
#include <psmks/paper/PaperCovariance.h>
#include <psmks/paper/PaperOptions.h>
#include <psmks/paper/PoseObjective.h>
#include <psmks/paper/TranslationRegression.h>

namespace psmks
{
/** The buffers of a match by the paper's scheme, kept from one to the next. */
struct PaperBuffers
{
  PoseObjective objective;
  TranslationProblem translation;
  PaperCovariance covariance;
  ScanFeatures reference, current;  //!< for the free-space score
};

/** Matches two scans by the scheme of the paper (section 2.3):
 *
 *  1. Orientation search at the present translation.
 *  2. Translation regression at the new orientation. The best of the step, half of it, a quarter
 * ... is taken, or none if each of them leaves the pose worse than the orientation search did.
 *  3. The update is accepted only if the pose is better than before (PoseObjective::isBetter()); if
 *     it is not, the search ends.
 *  4. Again from 1, until the steps are small or the iterations run out.
 *
 * Differs from the paper: that speaks of the error after both steps alone. What the orientation
 * search gains, often a hundredfold, then pays for a translation step that raises the error again,
 * and the Jacobian asks for steps up to twice too long. So each step has to pay for itself.
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
