/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Room.h>

#include <optional>
#include <random>
#include <vector>

namespace psmks
{
/** Boxes that fill rooms: desks and shelves along the walls, tables and chairs in the open; none in
 * the way of a route or of a door. */
class Furniture
{
 public:
  /** @param rooms to be filled; they must outlive this object */
  Furniture(const std::vector<Room>& rooms, const Route& route, std::mt19937_64& random);

  /** What stands there already. */
  void avoid(const Box& box) { taken_.push_back(box); }

  /** Places so many pieces, as evenly over the rooms as they fit.
   *  @return nothing where they do not fit */
  std::optional<std::vector<Box>> place(int pieces);

 private:
  Box drawAlongWall(const Room& room);
  Box drawInTheOpen(const Room& room);
  bool fits(const Box& box, double gap_m) const;
  double draw(double low, double high);

  const std::vector<Room>& rooms_;
  Route route_;  //!< densely sampled
  std::mt19937_64& random_;
  std::vector<Box> taken_;
};
}  // namespace psmks
