/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>

#include <cmath>
#include <deque>

namespace psmks
{
/** How fast a frame moves in the plane, in its own axes: forward, to the left, and turning to the
 * left. */
struct PlanarVelocity
{
  double x_m_s = 0, y_m_s = 0, phi_rad_s = 0;

  bool isFinite() const
  {
    return std::isfinite(x_m_s) && std::isfinite(y_m_s) && std::isfinite(phi_rad_s);
  }

  bool isZero() const { return x_m_s == 0 && y_m_s == 0 && phi_rad_s == 0; }
};

/** The velocity of a sensor that sits on a robot at T_robot_sensor: a turning robot swings it. */
PlanarVelocity velocityOfSensor(const PlanarVelocity& ofRobot, const Pose2& T_robot_sensor);

/** How fast a robot moves, from its motions between scans. The velocity is a mean over at least the
 * last kWindow_s, since the stamps of single scans jitter. */
class MeanVelocity
{
 public:
  /** Time over which the velocity is measured, at least. Evidence: with 0.1 and 0.4 s
   * the maps of logs are the same. */
  static constexpr double kWindow_s = 0.2;

  /** Gap between scans from which on the velocity is unknown. Evidence: with 1.5
   * and 6 s the maps of logs are the same. */
  static constexpr double kMaxAge_s = 3.0;

  /** Adds a motion. One that goes back in time replaces all before it; one that is not finite
   *  removes them.
   *  @param T_before_now the motion since the one before, with its covariance */
  void add(double stamp_s, const UncertainPose& T_before_now);

  /** The velocity of the robot in its own axes; 0 where it is not known: before the second motion,
   * where the motions span less than a quarter of kWindow_s, and where they span more than
   * kMaxAge_s. */
  PlanarVelocity velocity() const;

  /** The covariance of velocity(), by those of the motions, whose errors are taken as independent:
   * (m/s)^2, (rad/s)^2; 0 where the velocity is not known. */
  Eigen::Matrix3d covariance() const;

 private:
  struct Reading
  {
    double stamp_s;
    Eigen::Vector2d place_m;     //!< the frame is that of the robot at the first of all readings
    double heading_rad;          //!< not wrapped
    Eigen::Matrix3d covariance;  //!< of the motion that led here
  };

  double window_s() const;

  std::deque<Reading>
      readings_;  //!< the first is the youngest that is kWindow_s older than the last
};
}  // namespace psmks
