/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <random>

namespace psmks
{
/** Speeds of the rims of the two driven wheels. */
struct WheelSpeeds
{
  double left_mps = 0, right_mps = 0;

  /** The motion of the robot while its wheels keep these speeds: an arc. */
  Pose2 motion(double track_m, double duration_s) const;
};

/** A robot with differential drive; the defaults are a Pioneer 3-AT's. */
struct RobotOptions
{
  double track_m = 0.40;              //!< between the wheels
  double radius_m = 0.38;             //!< of the disc that collides
  double maxSpeed_mps = 1.2;          //!< of a wheel
  double maxAcceleration_mps2 = 1.0;  //!< of a wheel
  double wheelNoise = 0.05;           //!< a wheel runs at (1 + U(-noise, noise)) times its speed
  double noiseStep_s = 0.02;          //!< so long, then the noise is drawn anew, for each wheel
};

/** Where a robot is and where its wheels say it is. */
class Robot
{
 public:
  Robot(const RobotOptions& options, const Pose2& T_world_start)
      : options_(options), truth_(T_world_start), truthBefore_(T_world_start)
  {
  }

  /** Drives on for one noise step: the wheels approach the commanded speeds as fast as they can
   * accelerate, the odometry counts their speeds, the ground adds its noise. */
  void advance(const WheelSpeeds& commanded, std::mt19937_64& random);

  /** A collision: robot and odometry are back where they were before the last step, wheels at
   * rest. */
  void stop();

  const RobotOptions& options() const { return options_; }
  const Pose2& T_world_robot() const { return truth_; }
  const Pose2& T_start_odometry() const { return odometry_; }  //!< since the start, by the wheels
  const WheelSpeeds& speeds() const { return speeds_; }

 private:
  RobotOptions options_;
  Pose2 truth_, truthBefore_, odometry_, odometryBefore_;
  WheelSpeeds speeds_;
};
}  // namespace psmks
