/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Building.h>
#include <psmks/sim/Furniture.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kWall_m = 0.15;           // thickness of the wall between a corridor and its rooms
constexpr double kHalfPartition_m = 0.06;  // half the thickness of the wall between two rooms
constexpr char kClosed = '-', kDoorAtEnd = '>', kHall = 'H';

double width(char door) { return door == kHall ? 2 : 1; }

double widths(const std::string& doors)
{
  double sum = 0;
  for (const char door : doors) sum += width(door);
  return sum;
}

Pose2 startOf(const Route& route)
{
  const Eigen::Vector2d leg = route[1] - route[0];
  return {route[0].x(), route[0].y(), std::atan2(leg.y(), leg.x())};
}
}  // namespace

std::size_t Building::addFrontage(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m)
{
  frontages_.emplace_back(a_m, b_m);
  return frontages_.size() - 1;
}

std::size_t Building::addRooms(std::size_t frontage, double depth_m, const std::string& doors,
                               double margin_m, bool pilasters)
{
  constexpr double kMaxShift_m = 0.2;  // largest random shift of a wall between two rooms
  constexpr double kPilasterWidth_m = 0.4, kPilasterDepth_m = 0.2;
  std::uniform_real_distribution<double> shift_m(-kMaxShift_m, kMaxShift_m);
  Frontage& side = frontages_[frontage];
  const double unit_m = (side.length_m() - 2 * margin_m) / widths(doors);
  const std::size_t firstOpen = rooms_.size();
  double planned_m = margin_m, begin_m = margin_m;
  for (std::size_t i = 0; i < doors.size(); ++i)
  {
    planned_m += unit_m * width(doors[i]);
    const bool isLast = i + 1 == doors.size();
    const double end_m = isLast ? planned_m : planned_m + shift_m(random_);
    const Room room(side, {begin_m + kHalfPartition_m, end_m - kHalfPartition_m, kWall_m, depth_m,
                           doors[i] != kDoorAtEnd});
    if (doors[i] == kClosed)
      addClosedDoor(frontage, (begin_m + end_m) / 2);
    else
    {
      side.add({room.door_m(), Room::kDoor_m, kWall_m, false});
      rooms_.push_back(room);
    }
    if (pilasters && !isLast) side.add({end_m, kPilasterWidth_m, -kPilasterDepth_m});
    begin_m = end_m;
  }
  return firstOpen;
}

void Building::addClosedDoor(std::size_t frontage, double along_m)
{
  constexpr double kClosedDoor_m = 1.0;
  frontages_[frontage].add({along_m, kClosedDoor_m, kWall_m});
}

World Building::drawn() const
{
  World world;
  for (const Frontage& frontage : frontages_) frontage.drawInto(world);
  for (const Room& room : rooms_) room.drawInto(world);
  return world;
}

// A piece of furniture has four walls. Leaves of doors make up the rest of the number of walls.
Site Building::furnished(const Route& route, std::size_t walls)
{
  constexpr std::size_t kWallsOfBox = 4;
  World world = drawn();
  const std::size_t missing = walls - world.walls().size() - kWallsOfBox * boxes_.size();
  for (std::size_t i = 0; i < missing % kWallsOfBox; ++i) world.addWall(rooms_[i].leaf());
  std::optional<std::vector<Box>> pieces;
  while (!pieces)
  {
    Furniture furniture(rooms_, route, random_);
    for (const Box& box : boxes_) furniture.avoid(box);
    pieces = furniture.place(static_cast<int>(missing / kWallsOfBox));
  }
  pieces->insert(pieces->begin(), boxes_.begin(), boxes_.end());
  for (const Box& box : *pieces)
    world.addBox(box.T_world_box.translation(), box.size_m, box.T_world_box.phi_rad);
  return {world, startOf(route), route};
}
}  // namespace psmks
