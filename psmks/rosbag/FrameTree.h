/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/rosbag/BagFile.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The frames of a robot and the transforms between them, of a whole bag.
 *
 *     map --> odom ~~> base_link --> laser      --> stays the same, ~~> moves: the odometry
 */
class FrameTree
{
 public:
  struct Reading
  {
    double stamp_s;
    Pose2 T_parent_child;
  };

  void add(const BagTransform& transform);

  /** The frame of the robot that carries a sensor: the one below the first transform that moves, on
   * the way up from the sensor. Where none moves it is the topmost of base_link and base_footprint
   * on that way, and where there is none of these the sensor itself. */
  std::string robotOf(const std::string& sensorFrame) const;

  /** The pose of a frame seen from one above it, by the first transforms of the bag.
   *  @return none where the way up does not lead there */
  std::optional<Eigen::Isometry3d> poseOf(const std::string& frame, const std::string& above) const;

  /** How a frame moves in its parent, in the order of the bag; empty where it does not. */
  std::vector<Reading> motionOf(const std::string& frame) const;

 private:
  struct Edge
  {
    std::string parent;
    Eigen::Isometry3d first;
    bool moves = false;
    std::vector<Reading> readings;
  };

  std::map<std::string, Edge> edges_;  //!< by the child
};
}  // namespace psmks
