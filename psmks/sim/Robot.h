/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <random>

namespace psmks
{
/** The speeds of the rims of the two driven wheels. */
struct WheelSpeeds
{
  double left_mps = 0, right_mps = 0;

  /** The motion of the robot while the wheels keep these speeds. It is an arc. */
  Pose2 motion(double track_m, double duration_s) const;
};

/** A robot with differential drive. The defaults are those of a Pioneer 3-AT. */
struct RobotOptions
{
  double track_m = 0.40;              //!< distance between the wheels
  double radius_m = 0.38;             //!< radius of the disc that collides
  double maxSpeed_mps = 1.2;          //!< highest speed of a wheel
  double maxAcceleration_mps2 = 1.0;  //!< highest acceleration of a wheel
  double wheelNoise = 0.05;           //!< a wheel moves at (1 + U(-noise, noise)) times its speed
  double noiseStep_s = 0.02;          //!< time after which the noise of each wheel is drawn anew
};

/** A simulated robot: its true pose, its odometry and the speeds of its wheels. */
class Robot
{
 public:
  Robot(const RobotOptions& options, const Pose2& T_world_start)
      : options_(options), truth_(T_world_start), truthBefore_(T_world_start)
  {
  }

  /** Moves the robot for one noise step. The wheels approach the commanded speeds with their
   * highest acceleration. The odometry integrates the speeds of the wheels, the true pose those
   * with noise.
   */
  void advance(const WheelSpeeds& commanded, std::mt19937_64& random);

  /** Handles a collision: the true pose and the odometry return to where they were before the last
   * step, and the wheels stop. */
  void stop();

  const RobotOptions& options() const { return options_; }
  const Pose2& T_world_robot() const { return truth_; }
  const Pose2& T_start_odometry() const { return odometry_; }  //!< pose by the odometry
  const WheelSpeeds& speeds() const { return speeds_; }

 private:
  RobotOptions options_;
  Pose2 truth_, truthBefore_, odometry_, odometryBefore_;
  WheelSpeeds speeds_;
};
}  // namespace psmks
