/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/MatchingError.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** The residual of one associated ray as a linear function of the translation step s: e + slope.s.
 */
struct TranslationTerm
{
  double residual_m;      //!< e: reference value minus projected range
  Eigen::Vector2d slope;  //!< de / d(x, y)
  double weight;          //!< weight of the squared residual
};

/** A weighted linear least-squares problem for the translation step s: its cost is 1/2 sum w (e +
 * slope.s)^2. */
struct TranslationProblem
{
  std::vector<TranslationTerm> terms;
};

/** The derivative by (x, y) of a residual e = r0 / cos(b - phi0) - r' at the bearing direction
 * (cos b, sin b).
 *
 * FrozenBearing is the derivative of the paper and of the original PSM: the range r' grows by
 * cos b dx + sin b dy while the bearing b stays, so it is -(cos b, sin b).
 *
 * Full takes the change of the bearing into account. The residual is the distance to the line over
 * the cosine of incidence, (r0 - n.p) / cos(b - phi0), so at e = 0 the derivative is
 * -n / cos(b - phi0): a step along the wall changes nothing. The same derivative is used where e is
 * not 0, without the change of the cosine. The distance itself is linear in the step, so that one
 * step makes it zero. */
Eigen::Vector2d residualSlope(TranslationJacobian jacobian, const Eigen::Vector2d& direction,
                              const Eigen::Vector2d& refNormal);

/** Builds the problem of the associated rays at a pose. The weights are the reliabilities of the
 * segments (paper, section 2.2).
 *
 * Differs from the paper: the factor C / (e^2 + C) of the original PSM is left out. With
 * C = (70 cm)^2 and lines within 20 cm of each other it is close to 1. */
void buildTranslationProblem(const Projection& projection, const Associations& associations,
                             const SegmentReliability& reliability, TranslationJacobian jacobian,
                             TranslationProblem& problem);

/** Solves the problem in closed form: -(sum w s s')^-1 sum w s e. No step is made along a direction
 * that the rays do not constrain, as along a bare corridor with the full Jacobian.
 *  @return the step in metres, in the reference frame; zero without terms */
Eigen::Vector2d solveTranslation(const TranslationProblem& problem);
}  // namespace psmks
