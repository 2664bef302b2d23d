/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Box.h>
#include <psmks/sim/Frontage.h>
#include <psmks/sim/Route.h>

namespace psmks
{
/** A rectangular room behind the wall of a corridor, with a doorway near one of its corners.
 *
 *           corridor                      along the frontage ->
 *   --- door ------------------  0        into the wall
 *   +-- door ---------------+    near     |
 *   |    |                  |             v
 *   |    +--------+         |
 *   |    |  loop  |         |
 *   |    +--------+         |
 *   +-----------------------+    far
 *  begin                    end
 */
class Room
{
 public:
  static constexpr double kDoor_m = 1.2;

  struct Plan
  {
    double begin_m, end_m;  //!< along the frontage
    double near_m, far_m;   //!< into it
    bool doorAtBegin;
  };

  Room(const Frontage& frontage, const Plan& plan) : frontage_(frontage), plan_(plan) {}

  /** Along the frontage, of the centre of the doorway. */
  double door_m() const;

  /** Draws its walls without furniture; the passage to the corridor is the frontage's. */
  void drawInto(World& world) const;

  /** The leaf of its door, wide open. */
  World::Wall leaf() const;

  /** Where the leaf swings. */
  Box doorway() const;

  /** From the corridor into the room, once around a loop there and out again.
   *  @param toMiddle_m from the frontage to the line of the corridor that the route follows */
  Route visit(double toMiddle_m) const;

  /** A box against the wall opposite to the door (0) or against a side wall (1, 2).
   *  @param along 0 to 1: from one corner to the other */
  Box against(int side, const Eigen::Vector2d& size_m, double along) const;

  /** A box in the open, far enough from the walls for any angle.
   *  @param share of the way from corner to corner, 0 to 1 */
  Box inTheOpen(const Eigen::Vector2d& share, const Eigen::Vector2d& size_m, double phi_rad) const;

 private:
  double inward() const { return plan_.doorAtBegin ? 1 : -1; }  //!< along, from the door

  Frontage frontage_;
  Plan plan_;
};
}  // namespace psmks
