/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Observability.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** A start that went through Gauss-Newton. */
struct RefinedPose
{
  Pose2 T_ref_cur;
  double score = -1;      //!< free-space score, 0 to 1; -1 where too few rays were associated
  int associations = 0;   //!< associated rays
  double inlierRays = 0;  //!< rays of a scan that lie on surfaces of the other, mean of both
  bool converged = false;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  //!< of the scans alone
  Observability observability;
  double angleVariance_rad2 = 0;  //!< of the pair of lines whose directions are known best
  double bestPairAngleResidual_rad =
      0;  //!< angle left between these two where it is no chance, else 0
};
}  // namespace psmks
