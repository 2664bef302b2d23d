/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Observability.h>
#include <psmks/paper/PoseObjective.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** The information that associated segments hold about a pose, and the covariance of the estimate
 * that the paper's scheme makes of them. All rays of a pair of segments share the errors of its two
 * lines, so the independent unit of noise is the pair, not the ray. */
class PaperCovariance
{
 public:
  /** Computes the sums at the pose of the last evaluation of the objective. */
  void assign(const PoseObjective& objective, const Pose2& T_ref_cur);

  /** The information of the pairs of lines about (x, y, phi) if all of it is used: the sum of
   * C' S^-1 C over the pairs, with S the covariance of the difference of (r0, phi0) of both lines
   * and C the derivative of this difference by (x, y, phi). */
  const Eigen::Matrix3d& information() const { return information_; }

  /** Covariance of the estimate of (x, y, phi).
   *
   * The alternating searches solve Z'W e = 0, where Z holds the slopes of the regression and of the
   * orientation search, W the weights and e the residuals. Errors d of the lines move the solution
   * by -(Z'W J)^-1 Z'W H d, where J is the full Jacobian by (x, y, phi) and H that by the lines.
   * The rounding of the heading to the step of the fine orientation search is added.
   *  @param known 3 x k, orthonormal columns: the directions of (x, y, phi) that were estimated;
   * the covariance is zero in the others
   *  @return a matrix that is not finite if Z'W J has no inverse */
  Eigen::Matrix3d of(const Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>& known) const;

 private:
  /** The sum Z'W H of the rays of one pair of segments. */
  struct PairSum
  {
    int rays = 0;
    Eigen::Matrix<double, 3, 2> slopesByLine = Eigen::Matrix<double, 3, 2>::Zero();
  };

  void addRay(const PoseObjective& objective, const Association& association,
              const Pose2& T_ref_cur);
  void addPair(const Line& current, const Line& reference, const Pose2& T_ref_cur,
               const PairSum& pair);

  /** A row for each current segment, a column for each reference segment. */
  std::vector<PairSum> pairs_;
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d slopes_ = Eigen::Matrix3d::Zero();  //!< Z'W J
  Eigen::Matrix3d noise_ = Eigen::Matrix3d::Zero();   //!< Z'W H cov(d) H'W Z
  double orientationStep_rad_ = 0;
};
}  // namespace psmks
