/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <nav_msgs/Odometry.h>
#include <psmks/geometry/Pose2.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <string>
#include <vector>

namespace psmks::test
{
/** Writes a ROS 1 bag, message by message. */
class RosBagWriter
{
 public:
  explicit RosBagWriter(const std::string& path) : bag_(path, rosbag::bagmode::Write) {}

  /** Writes a scan of rays from -90 to 90 degrees in the frame "laser". */
  void scan(const std::string& topic, double stamp_s, const std::vector<float>& range_m)
  {
    sensor_msgs::LaserScan message;
    message.header.stamp = ros::Time(stamp_s);
    message.header.frame_id = "laser";
    message.angle_min = static_cast<float>(-kPi / 2);
    message.angle_max = static_cast<float>(kPi / 2);
    message.angle_increment = static_cast<float>(kPi / (static_cast<double>(range_m.size()) - 1));
    message.range_min = 0.05f;
    message.range_max = 30;
    message.ranges = range_m;
    bag_.write(topic, message.header.stamp, message);
  }

  void odometry(const std::string& topic, double stamp_s, const Pose2& T_odom_robot)
  {
    nav_msgs::Odometry message;
    message.header.stamp = ros::Time(stamp_s);
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    message.pose.pose.position.x = T_odom_robot.x_m;
    message.pose.pose.position.y = T_odom_robot.y_m;
    message.pose.pose.orientation = rotation(T_odom_robot.phi_rad);
    bag_.write(topic, message.header.stamp, message);
  }

  void transform(const std::string& topic, double stamp_s, const std::string& parent,
                 const std::string& child, const Pose2& T_parent_child)
  {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = ros::Time(stamp_s);
    transform.header.frame_id = parent;
    transform.child_frame_id = child;
    transform.transform.translation.x = T_parent_child.x_m;
    transform.transform.translation.y = T_parent_child.y_m;
    transform.transform.rotation = rotation(T_parent_child.phi_rad);
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    bag_.write(topic, transform.header.stamp, message);
  }

 private:
  static geometry_msgs::Quaternion rotation(double phi_rad)
  {
    geometry_msgs::Quaternion q;
    q.z = std::sin(phi_rad / 2);
    q.w = std::cos(phi_rad / 2);
    return q;
  }

  rosbag::Bag bag_;
};
}  // namespace psmks::test
