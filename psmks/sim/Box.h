/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <array>
#include <cmath>

namespace psmks
{
/** A rectangle of the plane at any angle. */
struct Box
{
  Pose2 T_world_box;  //!< pose of its centre
  Eigen::Vector2d size_m;

  /** Distance from a point to the box; 0 inside. */
  double distance_m(const Eigen::Vector2d& point_m) const
  {
    const Eigen::Vector2d inBox = T_world_box.inverse() * point_m;
    return (inBox.cwiseAbs() - size_m / 2).cwiseMax(0).norm();
  }

  /** Whether a strip of the given width, parallel to a side of one of the boxes, separates them. */
  bool isApart(const Box& other, double gap_m) const
  {
    const Eigen::Vector2d between = other.T_world_box.translation() - T_world_box.translation();
    const Eigen::Matrix2d mine = T_world_box.rotation(), others = other.T_world_box.rotation();
    const std::array<Eigen::Vector2d, 4> normals{mine.col(0), mine.col(1), others.col(0),
                                                 others.col(1)};
    for (const Eigen::Vector2d& normal : normals)
      if (std::abs(between.dot(normal)) >= reach_m(normal) + other.reach_m(normal) + gap_m)
        return true;
    return false;
  }

 private:
  /** How far the box extends from its centre in a direction. */
  double reach_m(const Eigen::Vector2d& direction) const
  {
    return (T_world_box.rotation().transpose() * direction).cwiseAbs().dot(size_m) / 2;
  }
};
}  // namespace psmks
