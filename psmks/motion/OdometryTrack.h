/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <optional>

namespace psmks
{
/** The path that the wheels of a robot measured, given as poses at times of their own. It tells the
 * pose at the time of a scan, which lies between two readings or shortly after the last one. */
class OdometryTrack
{
 public:
  /** A reading that is older than this tells no pose. Evidence: measured. */
  static constexpr double kMaxAge_s = 1.0;

  /** Adds a reading. Readings come in the order of their stamps. Of readings with the same stamp
   * the last one counts. After a reading that goes back in time, poses are those of that reading
   * until the next one. */
  void add(double stamp_s, const Pose2& T_odom_robot);

  /** The pose of the robot in the frame of the odometry at a time.
   *
   * Between the last two readings it is interpolated, each coordinate in the frame of the earlier
   * motion; after them the speed between them goes on. A time before both gives the earlier one.
   * Where only one reading is known, or the last two are more than kMaxAge_s apart, it is the last
   * reading.
   *
   *  @return none before the first reading, and later than kMaxAge_s after the last one */
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
