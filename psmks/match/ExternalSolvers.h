/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
struct JointProblem;
struct TranslationProblem;

/** Interface of solvers from outside the core, such as Ceres, that replace the closed form of the
 *  translation regression (paper's scheme) and Gauss-Newton (joint scheme). They minimise the same
 *  cost over the same residuals, with the associations held fixed. Implementations serve several
 *  threads at once. */
class ExternalSolvers
{
 public:
  virtual ~ExternalSolvers() = default;

  /** @param[in,out] step_m start and result of the translation step; unchanged on failure
   *  @return false if no minimum was found */
  virtual bool solveTranslation(const TranslationProblem& problem,
                                Eigen::Vector2d& step_m) const = 0;

  /** @param[in,out] T_ref_cur start and result; unchanged on failure
   *  @return false if no minimum was found */
  virtual bool solveJoint(const JointProblem& problem, Pose2& T_ref_cur) const = 0;
};
}  // namespace psmks
