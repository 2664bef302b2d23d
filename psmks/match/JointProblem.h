/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace psmks
{
/** A current line held against a reference line.
 *
 * Two residuals: the distance of the current line's anchor from the reference line,
 * n.(R q + t) - d, and the angle between both, phi_cur + phi - phi_ref, where (t, phi) is T_ref_cur
 * and R turns by phi. */
struct LinePairTerm
{
  Eigen::Vector2d refNormal;      //!< n, reference frame
  double refDistance_m;           //!< d
  Eigen::Vector2d curAnchor_m;    //!< q, the point of the current line where its errors of distance
                                  //!< and angle are independent; current frame
  double angle_rad;               //!< phi_cur - phi_ref, wrapped about the start
  Eigen::Matrix2d information;    //!< inverse covariance of the residual, of both lines
  double angleVariance_rad2 = 0;  //!< of the angle between both lines
};

/** A current circle held against a reference circle.
 *
 * Two residuals, the axes of R q + t - p. */
struct CirclePairTerm
{
  Eigen::Vector2d refCentre_m;  //!< p, where the current centre belongs, reference frame: the
                                //!< reference centre, put right by the difference of the radii
  Eigen::Vector2d curCentre_m;  //!< q, current frame
  Eigen::Matrix2d information;  //!< inverse covariance of the residual, of both circles
};

/** An unsegmented ray of one scan held against a line of the other.
 *
 * Residual: n.(R q + t) - d for a current point q and a reference line (n, d);
 * (R n).(p - t) - d for a reference point p and a current line (n, d). */
struct RayTerm
{
  bool pointIsCurrent;
  Eigen::Vector2d point_m;
  Eigen::Vector2d normal;
  double distance_m;
  double information;  //!< 1 / variance of the residual
};

/** What is known of the pose beforehand. */
struct PriorTerm
{
  Pose2 T_ref_cur;
  Eigen::Matrix3d information;  //!< of (x, y, phi) in reference axes
};

/** Least squares over the pose with fixed associations. The cost of a pair or a ray with
 * squared Mahalanobis distance s is rho(s) = k^2 log(1 + s / k^2) (Cauchy, k = kernelWidth); the
 * prior has no kernel. Cost = 1/2 sum rho(s_i) + 1/2 prior. */
struct JointProblem
{
  std::vector<LinePairTerm> linePairs;
  std::vector<CirclePairTerm> circlePairs;
  std::vector<RayTerm> rays;
  std::optional<PriorTerm> prior;
  double kernelWidth = 3.0;

  void clear()
  {
    linePairs.clear();
    circlePairs.clear();
    rays.clear();
    prior.reset();
  }
};
}  // namespace psmks
