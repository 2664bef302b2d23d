/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <cmath>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace psmks
{
struct StampedPose
{
  double stamp_s = 0;
  Pose2 pose;  //!< the heading is NaN where a file states none

  bool hasHeading() const { return !std::isnan(pose.phi_rad); }
};

/** Poses in the order in which they were driven. The stamps of a real log may contradict this
 * order.
 */
using Trajectory = std::vector<StampedPose>;

/** A trajectory file that cannot be read. The text gives file, line and reason. */
class TrajectoryFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

enum class StampOrder
{
  Rising,  //!< a stamp may repeat; one earlier than that of the line before is an error
  Any      //!< stamps may go backwards, as in some real logs
};

/** A trajectory as a file states it. */
struct TrajectoryFile
{
  Trajectory trajectory;  //!< at least one pose
  int rows = 0;
  int rowsWithoutPosition = 0;  //!< left out: their stamp, x or y is NaN or infinite
  int posesWithoutHeading = 0;  //!< see StampedPose

  /** What a user should know of it, each a sentence without a full stop. */
  std::vector<std::string> remarks() const;
};

/** Reads a planar trajectory with a pose on each line; '#' and '%' begin comments.
 *
 *     stamp x y z qx qy qz qw     TUM: the poses are projected to the plane
 *     stamp x y phi               MRPT ground truth: radians
 *
 * A quaternion may have any length. It states no heading if it is zero or not finite, and if all of
 * a file are 0 0 0 1 although the path turns: instruments that measure positions alone write so.
 *
 *  @throws TrajectoryFileError if the file cannot be read, a row is not a pose, none has a
 * position, or a stamp breaks the order */
TrajectoryFile readTrajectoryFile(const std::string& path, StampOrder order = StampOrder::Rising);

/** The trajectory of readTrajectoryFile() alone. */
Trajectory readTrajectory(const std::string& path, StampOrder order = StampOrder::Rising);

/** Writes a trajectory as TUM, "stamp x y z qx qy qz qw", with 9 decimals. */
void writeTum(std::ostream& out, const Trajectory& trajectory);

/** Writes a trajectory as MRPT's ground truth, which its graphslam-engine reads: "stamp x y phi",
 * phi in radians. */
void writeMrptGroundTruth(std::ostream& out, const Trajectory& trajectory);
}  // namespace psmks
