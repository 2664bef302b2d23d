/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <optional>

namespace psmks
{
/** Poses further apart in time are not interpolated. */
constexpr double kMaxGap_s = 2.0;

/** The two poses of a trajectory around a time; the same one twice where it is of that very time.
 */
struct Bracket
{
  StampedPose before, after;

  double gap_s() const { return after.stamp_s - before.stamp_s; }

  /** From a time between the two to the nearer of them. */
  double nearest_s(double stamp_s) const;

  /** On the straight line from one to the other, turning evenly. */
  Pose2 poseAt(double stamp_s) const;
};

/** None before the first and after the last pose and in gaps of more than kMaxGap_s.
 *  @param trajectory in the order of its stamps */
std::optional<Bracket> bracketAt(const Trajectory& trajectory, double stamp_s);

/** The pose at a time, interpolated; none where there is no bracket. */
std::optional<Pose2> poseAt(const Trajectory& trajectory, double stamp_s);
}  // namespace psmks
