/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/World.h>

#include <vector>

namespace psmks
{
/** The side of a corridor or of a room: a straight wall from a to b with free space on its left and
 * recesses, pilasters and doorways in it.
 *
 *       free          pilaster
 *  a ------+    +-------+  +--------+    +------- b
 *          |    |       +--+        |    |
 *          +----+  (the other way)  doorway: no back
 *          recess
 */
class Frontage
{
 public:
  struct Feature
  {
    double centre_m;  //!< from a
    double width_m;
    double depth_m;       //!< into the wall; negative: out of it; 0: nothing but a gap
    bool hasBack = true;  //!< false: one can pass
  };

  Frontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

  double length_m() const { return length_m_; }
  double angle_rad() const { return T_world_a_.phi_rad; }

  /** Features may come in any order but must not overlap. */
  void add(const Feature& feature) { features_.push_back(feature); }

  void drawInto(World& world) const;

  /** A place so far along the wall and so far into it. */
  Eigen::Vector2d at(double along_m, double into_m) const
  {
    return T_world_a_ * Eigen::Vector2d(along_m, -into_m);
  }

 private:
  Pose2 T_world_a_;  //!< x along the wall, y to the free side
  double length_m_;
  std::vector<Feature> features_;
};
}  // namespace psmks
