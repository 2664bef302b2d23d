/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/ExternalSolvers.h>

#include <memory>

namespace psmks
{
/** The solvers to give to a Matcher: those of Ceres where this library was built with Ceres, else
 * null, with which a Matcher refuses options that choose Ceres. */
std::shared_ptr<const ExternalSolvers> builtSolvers();
}  // namespace psmks
