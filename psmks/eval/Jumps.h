/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairError.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>

#include <vector>

namespace psmks
{
/** Two motions contradict each other if they differ by more than one of these. */
constexpr PairError kJumpLimit{0.3, degToRad(10)};

/** The number of jumps of an estimate: true motions that contradict both the estimate and the
 * odometry of the estimate's motion, so that a wrong match must have caused the difference. A
 * single wrong pose makes two jumps, there and back.
 *  @param odometry one pose for each pose of the estimate, in the same order
 *  @param truth short motions, for over long ones estimate and odometry differ by drift; motions
 *         whose ends have no pose in the estimate do not count */
int countJumps(const Trajectory& estimate, const Trajectory& odometry,
               const std::vector<Relation>& truth);

/** The true motions between consecutive poses of an estimate, if the truth was measured at both,
 * see CommonPose::isMeasured. */
std::vector<Relation> trueSteps(const Trajectory& estimate, const Trajectory& truth);
}  // namespace psmks
