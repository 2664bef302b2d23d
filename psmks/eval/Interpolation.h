/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <optional>

namespace psmks
{
/** Poses that are farther apart in time are not interpolated. */
constexpr double kMaxGap_s = 2.0;

/** The two poses of a trajectory around a time. Both are the same pose if its stamp is that time.
 */
struct Bracket
{
  StampedPose before, after;

  double gap_s() const { return after.stamp_s - before.stamp_s; }

  /** The difference between a time in the bracket and the nearer of the two stamps. */
  double nearest_s(double stamp_s) const;

  /** The pose on the straight line between the two, with the heading turning at a constant rate. */
  Pose2 poseAt(double stamp_s) const;
};

/** The poses around a time. There are none before the first and after the last pose, and in gaps of
 * more than kMaxGap_s.
 *  @param trajectory in the order of its stamps */
std::optional<Bracket> bracketAt(const Trajectory& trajectory, double stamp_s);

/** The interpolated pose at a time; nothing if there is no bracket. */
std::optional<Pose2> poseAt(const Trajectory& trajectory, double stamp_s);
}  // namespace psmks
