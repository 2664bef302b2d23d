/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace psmks
{
struct StampedPose
{
  double stamp_s = 0;
  Pose2 pose;
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

/** Reads a planar trajectory with a pose on each line; '#' and '%' begin comments.
 *
 *     stamp x y z qx qy qz qw     TUM: the poses are projected to the plane
 *     stamp x y phi               MRPT ground truth: radians
 *
 *  @throws TrajectoryFileError if the file cannot be read, a row is not a pose, or a stamp breaks
 *          the order */
Trajectory readTrajectory(const std::string& path, StampOrder order = StampOrder::Rising);

/** Writes a trajectory as TUM, "stamp x y z qx qy qz qw", with 9 decimals. */
void writeTum(std::ostream& out, const Trajectory& trajectory);

/** Writes a trajectory as MRPT's ground truth, which its graphslam-engine reads: "stamp x y phi",
 * phi in radians. */
void writeMrptGroundTruth(std::ostream& out, const Trajectory& trajectory);
}  // namespace psmks
