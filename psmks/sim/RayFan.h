/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** The free space in front of a robot: the polygon between the robot and the end points of its
 * rays.
 */
class RayFan
{
 public:
  /** The end point of a ray, as seen from the robot. */
  struct End
  {
    Eigen::Vector2d point_m;
    double bearing_rad, range_m;
  };

  /** Takes the rays of a scan that point at most 90.5 degrees away from straight ahead.
   *  @param farthest_m length to which longer rays and those without return are set */
  RayFan(const Scan& scan, const Pose2& T_robot_sensor, double farthest_m);

  /** The part of the fan between two bearings. */
  RayFan sector(double right_rad, double left_rad) const;

  /** The fan with its rays cut to a length. */
  RayFan clipped(double reach_m) const;

  int count() const { return static_cast<int>(ends_.size()); }
  double area_m2() const;
  double halfAngle_rad() const;  //!< half the angle between the outer rays
  double meanRange_m() const;    //!< 0 without rays

  /** The weighted mean of the centroids of the triangles between neighbouring rays. A triangle is
   * weighted with its area and the logarithm of its length. Without rays it is the place of the
   * robot. */
  Eigen::Vector2d areaCentre_m() const;

  /** Distance from a place to the polyline through the end points of the rays; infinity without
   * rays. */
  double outlineDistance_m(const Eigen::Vector2d& place_m) const;

  /** Distance from a place to the nearest end point of a ray; infinity without rays. */
  double clearance_m(const Eigen::Vector2d& place_m) const;

  /** Distance from the straight line between two places to the nearest end point of a ray; infinity
   * without rays. */
  double pathClearance_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;

  /** How far a lane of the given width is free along a bearing. It is the farthest range of the fan
   * if nothing lies in the lane, and 0 without rays. */
  double lane_m(double bearing_rad, double width_m) const;

 private:
  RayFan() = default;

  std::vector<End> ends_;  // counter-clockwise
};
}  // namespace psmks
