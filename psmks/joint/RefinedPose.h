/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Innovation.h>
#include <psmks/geometry/Observability.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/joint/GaussNewton.h>

#include <Eigen/Core>

namespace psmks
{
/** What became of a start that was refined: the pose, how well it explains both scans, and how well
 * they fix it. Without enough associations only the pose and their number are set. */
struct RefinedPose
{
  Pose2 T_ref_cur;
  double score = -1;        //!< free-space score, 0 to 1; -1 where too few rays were associated
  double logPosterior = 0;  //!< what rays and prior say for the pose, up to a constant of the
                            //!< match: logLikelihoodRatio() and JointMatch::logPrior(). Unit: nat
  int associations = 0;     //!< associated rays
  double inlierRays = 0;    //!< rays of a scan that lie on surfaces of the other, mean of both
  bool converged = false;   //!< whether the last steps fell below the limits of the options
  NormalEquations scans;    //!< at the pose, of the scans alone
  Innovation innovation;    //!< of the guess; no degree of freedom where it was not measured
  Observability observability;
  double angleVariance_rad2 = 0;  //!< of the pair of lines whose directions are known best
};
}  // namespace psmks
