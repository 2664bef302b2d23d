/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/ExternalSolvers.h>

#include <memory>

namespace psmks
{
/** The Ceres solvers where this library was built with them, else null: what a Matcher takes, so
 *  that it accepts or refuses `ceres` in its options. */
std::shared_ptr<const ExternalSolvers> builtSolvers();
}  // namespace psmks
