/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Observability.h>
#include <psmks/paper/PoseObjective.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** How well the lines of associated segments fix a pose, and how well the paper's estimate uses
 * them. Every associated ray of a pair of segments shares the errors of both lines, so the unit of
 * noise is the pair, not the ray. */
class PaperCovariance
{
 public:
  /** At the pose of the last evaluation of the objective. */
  void assign(const PoseObjective& objective, const Pose2& T_ref_cur);

  /** What the line pairs fix at best: sum C' S^-1 C over pairs, with S the covariance of the
   *  difference (r0, phi0) of both lines and C its derivative by (x, y, phi). */
  const Eigen::Matrix3d& information() const { return information_; }

  /** Covariance of the estimate. The two alternating searches solve Z'W e = 0, where Z holds the
   *  slopes of the regression and of the orientation search, W the weights, e the residuals. Line
   *  errors d move the solution by -(Z'W J)^-1 Z'W H d (J: the full Jacobian by x, y, phi; H: by
   * the lines), to which the step of the fine orientation search adds its rounding.
   *
   *  @param known 3 x k, orthonormal: the directions of (x, y, phi) that were estimated; the
   *         covariance is zero across them
   *  @return not finite where Z'W J has no inverse */
  Eigen::Matrix3d of(const Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>& known) const;

 private:
  /** Z'W H of one pair of segments, and the covariance of its difference of lines. */
  struct PairSum
  {
    int rays = 0;
    Eigen::Matrix<double, 3, 2> slopesByLine = Eigen::Matrix<double, 3, 2>::Zero();
  };

  void addRay(const PoseObjective& objective, const Association& association,
              const Pose2& T_ref_cur);
  void addPair(const Line& current, const Line& reference, const Pose2& T_ref_cur,
               const PairSum& pair);

  std::vector<PairSum> pairs_;  //!< current segment x reference segment
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d slopes_ = Eigen::Matrix3d::Zero();  //!< Z'W J
  Eigen::Matrix3d noise_ = Eigen::Matrix3d::Zero();   //!< Z'W H cov(d) H'W Z
  double orientationStep_rad_ = 0;
};
}  // namespace psmks
