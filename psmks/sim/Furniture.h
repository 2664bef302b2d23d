/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Room.h>

#include <optional>
#include <random>
#include <vector>

namespace psmks
{
/** Places boxes in rooms: desks and shelves along the walls, tables and chairs in the open. None of
 * them blocks a route or a door. */
class Furniture
{
 public:
  /** @param rooms to be furnished; they must outlive this object */
  Furniture(const std::vector<Room>& rooms, const Route& route, std::mt19937_64& random);

  /** Keeps furniture clear of a box that is already there. */
  void avoid(const Box& box) { taken_.push_back(box); }

  /** Places a number of pieces, distributed over the rooms as evenly as they fit.
   *  @return nothing if they do not fit */
  std::optional<std::vector<Box>> place(int pieces);

 private:
  Box drawAlongWall(const Room& room);
  Box drawInTheOpen(const Room& room);
  bool fits(const Box& box, double gap_m) const;
  double draw(double low, double high);

  const std::vector<Room>& rooms_;
  Route route_;  //!< points at a small spacing
  std::mt19937_64& random_;
  std::vector<Box> taken_;
};
}  // namespace psmks
