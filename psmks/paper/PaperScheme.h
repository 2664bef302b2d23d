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
/** Buffers of matches by the paper's scheme. Matches that share them allocate less. */
struct PaperBuffers
{
  PoseObjective objective;
  TranslationProblem translation;
  PaperCovariance covariance;
  ScanFeatures reference, current;  //!< input of the free-space score
};

/** Matches two scans by the scheme of the paper (section 2.3):
 *
 *  1. Orientation search at the present translation.
 *  2. Translation regression at the new orientation. The full step, half of it, a quarter and so on
 *     are tried, and the best is taken. If all of them are worse than no step, none is taken.
 *  3. If the pose is not better than before (PoseObjective::isBetter()), it is kept as it was, and
 *     the search ends.
 *  4. These steps are repeated until the changes are small or the iterations run out.
 *
 * Differs from the paper: it compares the error after both steps only. The orientation search often
 * lowers the error by a factor of a hundred, which would hide that the following translation step
 * raises it, and the paper's Jacobian gives steps up to twice too long. Here each of the two steps
 * has to lower the error by itself.
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
