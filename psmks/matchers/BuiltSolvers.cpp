/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/matchers/BuiltSolvers.h>
#ifdef PSMKS_WITH_CERES
#include <psmks/ceres/CeresSolvers.h>
#endif

namespace psmks
{
std::shared_ptr<const ExternalSolvers> builtSolvers()
{
#ifdef PSMKS_WITH_CERES
  static const std::shared_ptr<const ExternalSolvers> solvers = makeCeresSolvers();
  return solvers;
#else
  return nullptr;
#endif
}
}  // namespace psmks
