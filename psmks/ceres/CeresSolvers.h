/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/ExternalSolvers.h>

#include <memory>

namespace psmks
{
/** Ceres in place of the closed form of the translation regression and of Gauss-Newton in the joint
 *  scheme: the costs of TranslationProblem and JointProblem, to the letter. One thread, silent. */
std::shared_ptr<const ExternalSolvers> makeCeresSolvers();
}  // namespace psmks
