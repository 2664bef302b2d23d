/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/poses/CPose3D.h>
#include <psmks/logs/LogReader.h>
#include <psmks/motion/OdometryTrack.h>
#include <psmks/rosbag/BagFile.h>
#include <psmks/rosbag/FrameTree.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What a bag does not tell. */
struct RosBagOptions
{
  std::optional<Pose2> T_robot_sensor;       //!< else by the transforms of the bag
  std::optional<std::string> odometryTopic;  //!< else the one with most messages
};

/** Reads the scans of a ROS 1 bag. A sensor has the name of its topic of sensor_msgs/LaserScan.
 *
 * - Odometry is that of nav_msgs/Odometry, else the transform of /tf that moves the robot, at the
 *   stamps of the scans (OdometryTrack).
 * - The sensor is where /tf and /tf_static place it on the robot (FrameTree), else at its origin.
 * - A range that is not finite, or outside the limits of the message, is no return.
 * - The time of a sweep is that of the message. */
class RosBagReader : public LogReader
{
 public:
  /** Reads the odometry of the whole bag.
   *  @param sensorLabel the topic to read, with or without its slash; by default the one with most
   *      scans */
  explicit RosBagReader(const std::string& path,
                        const std::optional<std::string>& sensorLabel = std::nullopt,
                        const RosBagOptions& options = RosBagOptions());

  bool next(LaserFrame& frame) override;
  const std::string& damage() const override { return damage_; }
  std::vector<std::string> remarks() const override { return remarks_; }
  int entriesRead() const override { return scansRead_; }
  const std::optional<std::string>& sensorLabel() const override { return sensorLabel_; }
  /** Those of the whole bag, for its index tells them. */
  const std::map<std::string, int>& scansOfSensors() const override { return scansOfSensors_; }
  int stampsMadeUp() const override { return 0; }
  double shareRead() const override;

 private:
  void begin();
  void readOdometry();
  void placeSensor();
  std::optional<Pose2> motionUntil(double stamp_s);
  mrpt::obs::CObservation2DRangeScan::Ptr observation(const BagScan& scan) const;

  BagFile bag_;
  RosBagOptions options_;
  std::optional<std::string> sensorLabel_;
  std::map<std::string, int> scansOfSensors_;
  std::string damage_;
  std::vector<std::string> remarks_;
  int scansRead_ = 0;

  std::optional<BagScan> ahead_;  //!< the first scan, which was read to know its frame
  FrameTree frames_;
  std::string robotFrame_;
  mrpt::poses::CPose3D T_robot_sensor_;
  std::vector<FrameTree::Reading> odometry_;
  std::size_t nextReading_ = 0;  //!< the readings before it are part of the track
  OdometryTrack track_;
  std::optional<Pose2> T_odom_last_;  //!< pose at the last scan
};
}  // namespace psmks
