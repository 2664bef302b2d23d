/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairError.h>
#include <psmks/eval/Relations.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>

#include <vector>

namespace psmks
{
/** A motion further than this from another one, in either, contradicts it. */
constexpr PairError kJumpLimit{0.3, degToRad(10)};

/** How many of the true motions an estimate jumps over: it contradicts the truth, and the odometry
 * as well, so that a match must have moved it. A pose that jumps there and back makes two jumps.
 *  @param odometry one pose for each pose of the estimate, in the same order
 *  @param truth short motions: over long ones estimate and odometry drift apart without a jump.
 * Those whose ends have no pose do not count */
int countJumps(const Trajectory& estimate, const Trajectory& odometry,
               const std::vector<Relation>& truth);

/** The motions between consecutive poses of an estimate as they truly were, where the truth was
 * measured; see CommonPose. */
std::vector<Relation> trueSteps(const Trajectory& estimate, const Trajectory& truth);
}  // namespace psmks
