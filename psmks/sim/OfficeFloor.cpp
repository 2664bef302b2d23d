/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Building.h>
#include <psmks/sim/OfficeFloor.h>

#include <random>

namespace psmks
{
namespace
{
constexpr std::size_t kWalls = 420;
constexpr double kLength_m = 32, kCorridor_m = 1.8;
constexpr double kOuterRoomDepth_m = 4.1, kInnerRoomDepth_m = 4.05;
constexpr double kSouth_m = 4.1, kNorth_m = 20 - 4.1;  // outer sides of the long corridors
/** Sides of the corridor that joins them. */
constexpr double kWest_m = 15.1, kEast_m = kWest_m + kCorridor_m;

/** Letters for Building::addRooms(): open doors at a random end of each room. */
std::string openDoors(int rooms, std::mt19937_64& random)
{
  std::string doors;
  for (int i = 0; i < rooms; ++i) doors += random() % 2 == 0 ? '<' : '>';
  return doors;
}
}  // namespace

//   +----+----+----+----+----+----+----+   20 m
//   |    |    |    |    |    |    |    |           outer rooms, one of each seven closed
//   +- --+- --+-- -+----+- --+-- -+- --+   15.9
//     corridor
//   +-- --+-- --+- ---+  +- ---+-- --+-+   14.1
//   |     |     |     |  |     |     | |           inner rooms
//   +-----+-----+-----+  +-----+-----+-+
//   |     |     |     |  |     |     | |
//   +-- --+-- --+- ---+  +- ---+-- --+-+    5.9
//     corridor
//   +- --+- --+-- -+----+- --+-- -+- --+    4.1
//   |    |    |    |    |    |    |    |
//   +----+----+----+----+----+----+----+    0
//   0               15.1  16.9          32 m
Site makeOfficeFloor(unsigned seed)
{
  constexpr int kOuterRooms = 7, kInnerRooms = 3;
  std::mt19937_64 random(seed);
  Building building(seed);
  const auto addOuter = [&](const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m)
  {
    std::string doors = openDoors(kOuterRooms, random);
    doors[random() % kOuterRooms] = '-';
    building.addRooms(building.addFrontage(a_m, b_m), kOuterRoomDepth_m, doors, 0, false);
  };
  const auto addInner = [&](const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m)
  {
    building.addRooms(building.addFrontage(a_m, b_m), kInnerRoomDepth_m,
                      openDoors(kInnerRooms, random), 0, false);
  };
  constexpr double kInnerSouth_m = kSouth_m + kCorridor_m, kInnerNorth_m = kNorth_m - kCorridor_m;
  addOuter({0, kSouth_m}, {kLength_m, kSouth_m});
  addOuter({kLength_m, kNorth_m}, {0, kNorth_m});
  addInner({kLength_m, kInnerSouth_m}, {kEast_m, kInnerSouth_m});
  addInner({kWest_m, kInnerSouth_m}, {0, kInnerSouth_m});
  addInner({kEast_m, kInnerNorth_m}, {kLength_m, kInnerNorth_m});
  addInner({0, kInnerNorth_m}, {kWest_m, kInnerNorth_m});
  building.addFrontage({kEast_m, kInnerSouth_m}, {kEast_m, kInnerNorth_m});
  building.addFrontage({kWest_m, kInnerNorth_m}, {kWest_m, kInnerSouth_m});
  building.addFrontage({0, kInnerSouth_m}, {0, kSouth_m});
  building.addFrontage({0, kNorth_m}, {0, kInnerNorth_m});
  building.addFrontage({kLength_m, kSouth_m}, {kLength_m, kInnerSouth_m});
  building.addFrontage({kLength_m, kInnerNorth_m}, {kLength_m, kNorth_m});

  const double middle_m = kSouth_m + kCorridor_m / 2;
  return building.furnished({{kLength_m / 2, middle_m}, {kLength_m / 2, kNorth_m}}, kWalls);
}
}  // namespace psmks
