/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** A pose with the covariance of its (x, y, phi), in the axes of the frame it is seen from:
 *  m^2, m rad, rad^2. */
struct UncertainPose
{
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/** `T_a_c = T_a_b * T_b_c` with its covariance to first order; the errors of both are taken as
 *  independent. */
UncertainPose composed(const UncertainPose& T_a_b, const UncertainPose& T_b_c);

/** `T_b_c = T_a_b^-1 * T_a_c` with its covariance to first order; the errors of both are taken as
 *  independent. */
UncertainPose seenFrom(const UncertainPose& T_a_b, const UncertainPose& T_a_c);

/** The same motion seen from other frames: `T_newRef_newCur = T_newRef_ref * T_ref_cur *
 *  T_newCur_cur^-1`, with its covariance to first order; the two mountings count as exact.
 *
 *     newRef --T_newRef_ref--> ref --T_ref_cur--> cur <--T_newCur_cur-- newCur
 *
 * From sensors to robots with the mountings T_robot_sensor, back with their inverses. */
UncertainPose conjugated(const UncertainPose& T_ref_cur, const Pose2& T_newRef_ref,
                         const Pose2& T_newCur_cur);
}  // namespace psmks
