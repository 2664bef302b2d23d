/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace psmks
{
/** A sensor_msgs/LaserScan, its fields as ROS defines them. */
struct BagScan
{
  double stamp_s = 0;  //!< time of the first ray, by the message, or by the bag where it has none
  std::string frame;
  double firstAngle_rad = 0;   //!< of the first ray, counter-clockwise from the x axis
  double increment_rad = 0;    //!< from one ray to the next; negative where they go clockwise
  double timeIncrement_s = 0;  //!< from one ray to the next; 0 where it is unknown
  double minRange_m = 0, maxRange_m = 0;
  std::vector<float> range_m;
};

/** A pose of a nav_msgs/Odometry. */
struct BagOdometry
{
  double stamp_s = 0;
  std::string robotFrame;
  Pose2 T_odom_robot;
};

/** A transform of /tf or /tf_static. */
struct BagTransform
{
  double stamp_s = 0;
  std::string parent, child;
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};

/** Something of which a bag holds messages. */
struct BagTopic
{
  std::string name;
  std::size_t messages = 0;
};

/** A ROS 1 bag of version 2.0, read by the library of ROS. Names of frames are without the slash at
 * their begin that old ones have.
 *
 * Built without that library, every bag is one that cannot be read. No function throws: error()
 * tells what went wrong, as a part of a sentence, and what was read before it is given. */
class BagFile
{
 public:
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  const std::string& error() const { return error_; }

  /** The topics of 2D scans, and of odometry, each in the order of their names. */
  const std::vector<BagTopic>& scanTopics() const { return scanTopics_; }
  const std::vector<BagTopic>& odometryTopics() const { return odometryTopics_; }

  /** Calls a function with every message of a topic of odometry, in the order of the bag. */
  void forEachOdometry(const std::string& topic,
                       const std::function<void(const BagOdometry&)>& use);

  /** Calls a function with every transform, those of /tf_static and /tf alike. */
  void forEachTransform(const std::function<void(const BagTransform&)>& use);

  /** Begins to read the scans of a topic. */
  void openScans(const std::string& topic);

  /** Reads the next scan of the topic.
   *  @return false after the last one, and after an error */
  bool nextScan(BagScan& scan);

 private:
  struct Content;

  std::unique_ptr<Content> content_;  //!< null where the bag cannot be read
  std::string error_;
  std::vector<BagTopic> scanTopics_, odometryTopics_;
};
}  // namespace psmks
