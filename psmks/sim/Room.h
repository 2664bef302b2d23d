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
    double begin_m, end_m;  //!< coordinates along the frontage
    double near_m, far_m;   //!< depths behind the frontage
    bool doorAtBegin;
  };

  Room(const Frontage& frontage, const Plan& plan) : frontage_(frontage), plan_(plan) {}

  /** The coordinate along the frontage of the centre of the doorway. */
  double door_m() const;

  /** Draws the walls of the room without furniture. The passage through the wall of the corridor
   * belongs to the frontage. */
  void drawInto(World& world) const;

  /** The leaf of the door, which stands wide open. */
  World::Wall leaf() const;

  /** The area in which the leaf of the door swings. */
  Box doorway() const;

  /** A route from the corridor into the room, around a loop there, and back.
   *  @param toMiddle_m distance from the frontage to the line that the route follows in the
   *      corridor */
  Route visit(double toMiddle_m) const;

  /** A box at a wall.
   *  @param side 0 is the wall opposite the door, 1 and 2 are the side walls
   *  @param along place along the wall, 0 to 1 from one corner to the other */
  Box against(int side, const Eigen::Vector2d& size_m, double along) const;

  /** A box that keeps clear of the walls at any angle.
   *  @param share its place as shares of the way between opposite walls, 0 to 1 */
  Box inTheOpen(const Eigen::Vector2d& share, const Eigen::Vector2d& size_m, double phi_rad) const;

 private:
  double inward() const
  {
    return plan_.doorAtBegin ? 1 : -1;
  }  //!< direction from the door along the frontage

  Frontage frontage_;
  Plan plan_;
};
}  // namespace psmks
