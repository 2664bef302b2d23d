/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Frontage.h>
#include <psmks/sim/Room.h>
#include <psmks/sim/Worlds.h>

#include <random>
#include <string>
#include <vector>

namespace psmks
{
/** Corridors with rooms behind their walls. */
class Building
{
 public:
  explicit Building(unsigned seed) : random_(seed) {}

  /** The side of a corridor from a to b, free space on its left.
   *  @return its number */
  std::size_t addFrontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

  /** Divides a frontage into rooms, one a letter: `<` an open door near the beginning, `>` near the
   * end, `-` a closed one in a recess; `H` a hall, as wide as two, open near its beginning.
   *  @param depth_m of the rooms and the wall before them
   *  @param margin_m of the frontage without rooms at both ends
   *  @param pilasters between the rooms, in the corridor
   *  @return the number of its first open room; the others follow */
  std::size_t addRooms(std::size_t frontage, double depth_m, const std::string& doors,
                       double margin_m, bool pilasters);

  /** A closed door in a recess, so far along. */
  void addClosedDoor(std::size_t frontage, double along_m);

  /** A thing that stands there whatever else does. */
  void addBox(const Box& box) { boxes_.push_back(box); }

  const Room& room(std::size_t open) const { return rooms_[open]; }

  /** Draws everything and furnishes the rooms until the world has so many walls; the route, which
   *  furniture keeps clear of, says where a robot starts. */
  Site furnished(const Route& route, std::size_t walls);

 private:
  World drawn() const;

  std::mt19937_64 random_;
  std::vector<Frontage> frontages_;
  std::vector<Room> rooms_;
  std::vector<Box> boxes_;
};
}  // namespace psmks
