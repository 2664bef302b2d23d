/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <limits>

namespace psmks
{
/** How well an information matrix of (x, y, phi) constrains the position and the heading. */
struct Observability
{
  /** Unit vector along which the position is least certain. */
  Eigen::Vector2d weakDirection = Eigen::Vector2d::UnitX();
  /** Standard deviation along it if the heading is estimated too; may be infinite. */
  double weakSigma_m = 0;
  /** Standard deviation of the heading if the position is estimated too; may be infinite. */
  double headingSigma_rad = 0;
};

/** Finds the weak direction and its standard deviation from the smaller eigenvalue of the Schur
 * complement of the heading, and the standard deviation of the heading from the Schur complement of
 * the position (docs/derivations.md, "Degeneracy").
 *  @param information symmetric and positive semi-definite, of (x, y, phi) in 1/m^2, 1/(m rad),
 *      1/rad^2 */
Observability observability(const Eigen::Matrix3d& information);

/** What an information matrix fixes of the position at a given heading. Its heading part means
 * nothing. */
Observability observabilityAtHeading(const Eigen::Matrix3d& information);

/** How the position that suits a heading best moves with it, in m/rad: -H_tt^-1 H_tphi. Zero along
 * a direction in which H_tt fixes no position.
 *  @param weakestSigma_m zero also along a direction in which the position, at a given heading, has
 *      a larger standard deviation: what hardly fixes a position does not say how it moves */
Eigen::Vector2d positionPerHeading(const Eigen::Matrix3d& information,
                                   double weakestSigma_m = std::numeric_limits<double>::infinity());

/** A pose turned to a heading as the scans leave it open: about the point of the reference frame
 * about which a turn changes least of what they fix, so that positionPerHeading() is its
 * derivative.
 *  @param weakestSigma_m see positionPerHeading() */
Pose2 turnedTo(double phi_rad, const Pose2& T_ref_cur, const Eigen::Matrix3d& information,
               double weakestSigma_m);
}  // namespace psmks
