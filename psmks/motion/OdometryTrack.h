/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <optional>

namespace psmks
{
/** The path that wheels measured, as absolute readings at their own times, and the pose at the
 * times of scans between and shortly after them. */
class OdometryTrack
{
 public:
  /** A reading older than this says nothing of the present. */
  static constexpr double kMaxAge_s = 1.0;

  /** Readings come in the order of time; where one does not, nothing is interpolated. */
  void add(double stamp_s, const Pose2& T_odom_robot);

  /** The pose between the last two readings, or after the last one at the speed between them; none
   *  before the first reading and kMaxAge_s after the last. */
  std::optional<Pose2> poseAt(double stamp_s) const;

 private:
  struct Reading
  {
    double stamp_s;
    Pose2 T_odom_robot;
  };
  std::optional<Reading> last_, beforeLast_;
};
}  // namespace psmks
