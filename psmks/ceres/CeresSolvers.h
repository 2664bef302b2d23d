/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/ExternalSolvers.h>

#include <memory>

namespace psmks
{
/** Solvers that use Ceres in place of the closed form of the translation regression and of
 * Gauss-Newton in the joint scheme. They minimise exactly the costs of TranslationProblem and
 * JointProblem, in one thread and without output. */
std::shared_ptr<const ExternalSolvers> makeCeresSolvers();
}  // namespace psmks
