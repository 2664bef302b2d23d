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

/** In the order in which they were driven, which the stamps of a real log may contradict. */
using Trajectory = std::vector<StampedPose>;

/** A trajectory file that cannot be read; the text names file, line and reason. */
class TrajectoryFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

enum class StampOrder
{
  Rising,  //!< a stamp may repeat, but an earlier one than the line before is damage
  Any      //!< as a log with stamps that go backwards leaves them
};

/** Reads a planar trajectory, one pose a line; '#' and '%' begin comments.
 *
 *     stamp x y z qx qy qz qw     TUM: the poses are projected to the plane
 *     stamp x y phi               MRPT ground truth: radians
 *
 *  @throws TrajectoryFileError */
Trajectory readTrajectory(const std::string& path, StampOrder order = StampOrder::Rising);

/** Writes TUM: "stamp x y z qx qy qz qw", 9 decimals of the stamp. */
void writeTum(std::ostream& out, const Trajectory& trajectory);

/** Writes MRPT's ground truth, as its graphslam-engine reads it: "stamp x y phi", radians. */
void writeMrptGroundTruth(std::ostream& out, const Trajectory& trajectory);
}  // namespace psmks
