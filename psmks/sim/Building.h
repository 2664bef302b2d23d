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
/** Corridors with furnished rooms behind their walls, which is built up step by step. */
class Building
{
 public:
  explicit Building(unsigned seed) : random_(seed) {}

  /** Adds the side of a corridor from a to b, with the free space on its left.
   *  @return its number */
  std::size_t addFrontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

  /** Divides a frontage into rooms.
   *  @param doors a letter for each room: `<` has an open door near its beginning, `>` near its
   * end,
   *         `-` has a closed one in a recess; `H` is a hall of double width, open near its
   * beginning
   *  @param depth_m of a room together with the wall to the corridor
   *  @param margin_m length at either end of the frontage that has no rooms
   *  @param pilasters whether there are pilasters in the corridor between the rooms
   *  @return the number of the first of its open rooms; the other ones follow it */
  std::size_t addRooms(std::size_t frontage, double depth_m, const std::string& doors,
                       double margin_m, bool pilasters);

  /** Adds a closed door in a recess.
   *  @param along_m distance of its centre from the beginning of the frontage */
  void addClosedDoor(std::size_t frontage, double along_m);

  /** Adds a box that is part of the building; furniture is kept clear of it. */
  void addBox(const Box& box) { boxes_.push_back(box); }

  const Room& room(std::size_t open) const { return rooms_[open]; }

  /** Draws all walls, and furnishes the rooms until the world has the wanted number of walls.
   *  @param route stays free of furniture; the robot starts at its first point */
  Site furnished(const Route& route, std::size_t walls);

 private:
  World drawn() const;

  std::mt19937_64 random_;
  std::vector<Frontage> frontages_;
  std::vector<Room> rooms_;
  std::vector<Box> boxes_;
};
}  // namespace psmks
