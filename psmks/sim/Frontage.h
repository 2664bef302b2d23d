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
  /** A recess, a pilaster or a doorway. */
  struct Feature
  {
    double centre_m;  //!< distance of its centre from a
    double width_m;
    double depth_m;       //!< into the wall; negative: out of it; 0: only a gap
    bool hasBack = true;  //!< false: an open doorway
  };

  Frontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

  double length_m() const { return length_m_; }
  double angle_rad() const { return T_world_a_.phi_rad; }

  /** Adds a feature. They may come in any order but must not overlap. */
  void add(const Feature& feature) { features_.push_back(feature); }

  void drawInto(World& world) const;

  /** The place at a distance along the wall and a depth into it. */
  Eigen::Vector2d at(double along_m, double into_m) const
  {
    return T_world_a_ * Eigen::Vector2d(along_m, -into_m);
  }

 private:
  Pose2 T_world_a_;  //!< at a, with x along the wall and y to the free side
  double length_m_;
  std::vector<Feature> features_;
};
}  // namespace psmks
