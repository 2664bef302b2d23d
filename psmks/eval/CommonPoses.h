/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <vector>

namespace psmks
{
/** A pose of an estimated trajectory and the true one at the same time, each in its own world. */
struct CommonPose
{
  double stamp_s = 0;
  Pose2 T_estimated, T_true;

  /** The truth is known here as well as the estimate: it has a pose at this very time (up to
   * kStampTolerance_s), or lies at least as dense. Elsewhere T_true stands on the straight line
   * between two poses that are further apart, which is good enough for an error of position, but
   * not for one of the motion from scan to scan. */
  bool isMeasured = false;
};

/** The poses of an estimate, in its order, at which a truth is known: interpolated to their stamps,
 * across gaps of kMaxGap_s at most. The stamps of the estimate may repeat and go backwards.
 *
 * A truth whose stamps are but the numbers 0, 1, 2, ... of its rows (MRPT's UWB data set) while the
 * estimate has times belongs to the estimate's poses row by row. Of one pose more the first has no
 * row: a log that begins with an observation has one before its first action. With other numbers of
 * rows nobody knows which pose is whose, and there are no common poses.
 *
 * @param truth in the order of its stamps */
std::vector<CommonPose> commonPoses(const Trajectory& estimate, const Trajectory& truth);

/** Are the stamps the numbers 0, 1, 2, ...? */
bool isNumbered(const Trajectory& trajectory);
}  // namespace psmks
