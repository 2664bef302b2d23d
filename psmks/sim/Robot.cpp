/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Robot.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
double approached_mps(double speed_mps, double commanded_mps, const RobotOptions& robot)
{
  const double most_mps = robot.maxAcceleration_mps2 * robot.noiseStep_s;
  const double target_mps = std::clamp(commanded_mps, -robot.maxSpeed_mps, robot.maxSpeed_mps);
  return speed_mps + std::clamp(target_mps - speed_mps, -most_mps, most_mps);
}
}  // namespace

// An arc of length l that turns by phi has a chord of l sin(phi / 2) / (phi / 2) in the direction
// phi / 2.
Pose2 WheelSpeeds::motion(double track_m, double duration_s) const
{
  const double length_m = (left_mps + right_mps) / 2 * duration_s;
  const double phi_rad = (right_mps - left_mps) / track_m * duration_s;
  const double half_rad = phi_rad / 2;
  const double chord_m = half_rad == 0 ? length_m : length_m * std::sin(half_rad) / half_rad;
  return {chord_m * std::cos(half_rad), chord_m * std::sin(half_rad), wrapAngle(phi_rad)};
}

void Robot::advance(const WheelSpeeds& commanded, std::mt19937_64& random)
{
  truthBefore_ = truth_;
  odometryBefore_ = odometry_;
  speeds_.left_mps = approached_mps(speeds_.left_mps, commanded.left_mps, options_);
  speeds_.right_mps = approached_mps(speeds_.right_mps, commanded.right_mps, options_);

  std::uniform_real_distribution<double> noise(-options_.wheelNoise, options_.wheelNoise);
  WheelSpeeds noisy = speeds_;
  noisy.left_mps *= 1 + noise(random);
  noisy.right_mps *= 1 + noise(random);
  odometry_ = odometry_ * speeds_.motion(options_.track_m, options_.noiseStep_s);
  truth_ = truth_ * noisy.motion(options_.track_m, options_.noiseStep_s);
}

void Robot::stop()
{
  truth_ = truthBefore_;
  odometry_ = odometryBefore_;
  speeds_ = {};
}
}  // namespace psmks
