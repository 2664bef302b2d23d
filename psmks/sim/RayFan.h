/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** The free space before a robot: the fan between it and the ends of its rays. */
class RayFan
{
 public:
  /** Where a ray ends, seen from the robot. */
  struct End
  {
    Eigen::Vector2d point_m;
    double bearing_rad, range_m;
  };

  /** The rays of a scan that point forward, at most 90.5 degrees aside. Those that are longer and
   *  those without return end there.
   *  @param farthest_m from the scanner */
  RayFan(const Scan& scan, const Pose2& T_robot_sensor, double farthest_m);

  /** The part between two bearings. */
  RayFan sector(double right_rad, double left_rad) const;

  /** The same with no ray longer than the reach. */
  RayFan clipped(double reach_m) const;

  int count() const { return static_cast<int>(ends_.size()); }
  double area_m2() const;
  double halfAngle_rad() const;  //!< half of the angle between the outermost rays
  double meanRange_m() const;    //!< 0 without rays

  /** Mean of the centroids of its triangles, each weighted with its area and the logarithm of its
   *  length; the robot's own place where the fan is empty. */
  Eigen::Vector2d areaCentre_m() const;

  /** Distance from a place to the outline that joins the ends of the rays, infinity without rays.
   */
  double outlineDistance_m(const Eigen::Vector2d& place_m) const;

  /** Distance from a place to the nearest end of a ray, infinity without rays. */
  double clearance_m(const Eigen::Vector2d& place_m) const;

  /** Distance from the way between two places to the nearest end of a ray, infinity without rays.
   */
  double wayClearance_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;

  /** How far a lane of a width is free along a bearing: the farthest the rays see where nothing is
   *  in it, 0 without rays. */
  double lane_m(double bearing_rad, double width_m) const;

 private:
  RayFan() = default;

  std::vector<End> ends_;  // counter-clockwise
};
}  // namespace psmks
