/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Trajectory.h>

#include <cmath>
#include <vector>

namespace psmks
{
/** An estimated pose and the true pose at the same time, each in the frame of its own world. */
struct CommonPose
{
  double stamp_s = 0;
  Pose2 T_estimated, T_true;

  /** Whether the truth was measured here: it has a pose within kStampTolerance_s of this time, or
   * its poses are at least as dense as those of the estimate. Otherwise T_true is interpolated on a
   * straight line between poses that are farther apart. This is good enough for errors of
   * positions, but not for errors of motions from scan to scan. */
  bool isMeasured = false;

  /** Whether both headings are known, see StampedPose. */
  bool hasHeadings() const
  {
    return !std::isnan(T_estimated.phi_rad) && !std::isnan(T_true.phi_rad);
  }
};

/** The poses of an estimate, in its order, for which the truth is known. The truth is interpolated
 * to their stamps, across gaps of at most kMaxGap_s. The stamps of the estimate may repeat and go
 * backwards.
 *
 * If the stamps of the truth are only the numbers 0, 1, 2, ... of its rows (MRPT's UWB data set)
 * and those of the estimate are times, then rows and poses are taken in pairs. If there is one pose
 * more than rows, the first pose has no row: a log that begins with an observation has a scan
 * before its first action. With other numbers the correspondence is unknown, and there are no
 * common poses.
 *
 * @param truth in the order of its stamps */
std::vector<CommonPose> commonPoses(const Trajectory& estimate, const Trajectory& truth);

/** Whether the stamps of a trajectory are the numbers 0, 1, 2, ... */
bool isNumbered(const Trajectory& trajectory);
}  // namespace psmks
