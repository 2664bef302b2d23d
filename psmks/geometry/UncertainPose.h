/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** A pose `T_a_b` with the covariance of its (x, y, phi), in the axes of frame a: m^2, m rad,
 * rad^2.
 */
struct UncertainPose
{
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/** `T_a_c = T_a_b * T_b_c` with its covariance to first order. The errors of the two poses are
 * taken for independent. */
UncertainPose composed(const UncertainPose& T_a_b, const UncertainPose& T_b_c);

/** `T_b_c = T_a_b^-1 * T_a_c` with its covariance to first order. The errors of the two poses are
 * taken for independent. */
UncertainPose seenFrom(const UncertainPose& T_a_b, const UncertainPose& T_a_c);

/** Covariance of the best estimate of a pose from a guess and from independent scans,
 * (guess^-1 + information)^-1. It is positive definite also where the scans say nothing of a
 * direction, for variances of the guess up to 1e6 m^2: beyond that a double keeps no digit of what
 * the scans know across that direction.
 *  @param guess positive definite
 *  @param information of the scans, positive semidefinite */
Eigen::Matrix3d fusedCovariance(const Eigen::Matrix3d& guess, const Eigen::Matrix3d& information);

/** What independent scans knew of a pose, where fusedCovariance() gave its covariance: the inverse
 * of that function. Directions that seem to be known less than from the guess count as not known.
 *  @param fused, guess positive definite
 *  @return positive semidefinite */
Eigen::Matrix3d informationBeyond(const Eigen::Matrix3d& guess, const Eigen::Matrix3d& fused);

/** The same motion between other frames that are fixed to the old ones: `T_newRef_newCur =
 * T_newRef_ref * T_ref_cur * T_newCur_cur^-1`, with its covariance to first order. The two fixed
 * transformations count as exact.
 *
 *     newRef --T_newRef_ref--> ref --T_ref_cur--> cur <--T_newCur_cur-- newCur
 *
 * The covariance is bounded (boundedCovariance()), so that long levers leave it positive definite.
 * With the mountings T_robot_sensor it turns the motion of a sensor into that of its robot; with
 * the inverses of the mountings it turns the motion of a robot into that of its sensor. */
UncertainPose conjugated(const UncertainPose& T_ref_cur, const Pose2& T_newRef_ref,
                         const Pose2& T_newCur_cur);
}  // namespace psmks
