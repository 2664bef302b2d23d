/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/MatchingError.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** One associated ray as a function of the translation step s: residual e + slope.s. */
struct TranslationTerm
{
  double residual_m;      //!< e: reference value minus projected range
  Eigen::Vector2d slope;  //!< de / d(x, y)
  double weight;          //!< of the squared residual
};

/** Weighted linear least squares over a translation step: cost = 1/2 sum w (e + slope.s)^2. */
struct TranslationProblem
{
  std::vector<TranslationTerm> terms;
};

/** Slope of a residual e = r0 / cos(b - phi0) - r' at bearing direction (cos b, sin b).
 *
 *  FrozenBearing, the paper's (as original PSM): the range r' grows by cos b dx + sin b dy and the
 *  bearing b stays, so de = -(cos b, sin b).
 *  Full: the bearing changes too. e is the distance to the line over the cosine of incidence,
 *  (r0 - n.p) / cos(b - phi0), so at e = 0 de = -n / cos(b - phi0): a step along the wall changes
 *  nothing. The same slope serves away from e = 0, where the change of the cosine is left out: the
 *  distance is linear in the step, and one step solves it. */
Eigen::Vector2d residualSlope(TranslationJacobian jacobian, const Eigen::Vector2d& direction,
                              const Eigen::Vector2d& refNormal);

/** The associated rays of a pose as a problem. Weights are reliabilities (paper, section 2.2).
 *
 *  Differs from the paper: the factor C / (e^2 + C) that it takes over from original PSM is left
 *  out. With C = (70 cm)^2 and lines within 20 cm of each other it is close to 1. */
void buildTranslationProblem(const Projection& projection, const Associations& associations,
                             const SegmentReliability& reliability, TranslationJacobian jacobian,
                             TranslationProblem& problem);

/** The step in closed form: -(sum w s s')^-1 sum w s e. A direction that the rays do not fix
 *  (bare corridor, full Jacobian) is not stepped along. Zero without terms. */
Eigen::Vector2d solveTranslation(const TranslationProblem& problem);
}  // namespace psmks
