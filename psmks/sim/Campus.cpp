/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Building.h>
#include <psmks/sim/Campus.h>

namespace psmks
{
namespace
{
constexpr std::size_t kWalls = 507;
constexpr double kLength_m = 46, kCorridor_m = 2.2;
constexpr double kOuterRoomDepth_m = 5.8, kInnerRoomDepth_m = 4.8, kBlockHeight_m = 10;
/** Outer side of the corridors around the blocks. */
constexpr double kHeight_m = kBlockHeight_m + 2 * kCorridor_m;
constexpr double kCrossing_m = 20;  // where the corridor between the blocks begins
constexpr double kMiddle_m = kCorridor_m / 2;

/** The rooms of a block along both of its long corridors. */
struct Block
{
  std::size_t south, north;  //!< number of the first open room of each side
};

Block addBlock(Building& building, double left_m, double right_m, const std::string& southDoors,
               const std::string& northDoors)
{
  const double low_m = kCorridor_m, high_m = kCorridor_m + kBlockHeight_m;
  const std::size_t south = building.addFrontage({right_m, low_m}, {left_m, low_m});
  const std::size_t west = building.addFrontage({left_m, low_m}, {left_m, high_m});
  const std::size_t north = building.addFrontage({left_m, high_m}, {right_m, high_m});
  const std::size_t east = building.addFrontage({right_m, high_m}, {right_m, low_m});
  for (const std::size_t side : {west, east}) building.addClosedDoor(side, kBlockHeight_m / 2);
  constexpr double kMargin_m = 0.15;
  return {building.addRooms(south, kInnerRoomDepth_m, southDoors, kMargin_m, false),
          building.addRooms(north, kInnerRoomDepth_m, northDoors, kMargin_m, false)};
}

/** Adds two rows of pillars to a hall. The route leads around one of the rows. */
void addPillars(Building& building, const Room& hall)
{
  const Eigen::Vector2d size_m(0.3, 0.3);
  for (const double along : {0.17, 0.5, 0.83})
    for (const double into : {0.295, 0.75})
      building.addBox(hall.inTheOpen({along, into}, size_m, 0));
}

Route roundTrip(const Building& building, std::size_t homeRoom,
                const std::vector<std::size_t>& onTheSouth,
                const std::vector<std::size_t>& onTheNorth)
{
  const double east_m = kCrossing_m + kMiddle_m, north_m = kHeight_m - kMiddle_m;
  const Route home = building.room(homeRoom).visit(kMiddle_m);
  Route route{home[1], home[0]};
  const auto visit = [&route, &building](std::size_t room)
  {
    const Route detour = building.room(room).visit(kMiddle_m);
    route.insert(route.end(), detour.begin(), detour.end());
  };
  for (const std::size_t room : onTheSouth) visit(room);
  route.insert(route.end(), {{east_m, kMiddle_m}, {east_m, north_m}});
  for (const std::size_t room : onTheNorth) visit(room);
  route.insert(route.end(), {{kMiddle_m, north_m}, {kMiddle_m, kMiddle_m}, home[0]});
  return route;
}
}  // namespace

//   +-----+-----+-----+-----+-----+-----------+-----+-----+   20.2 m    rooms: north
//   |     |     |     |     |     |   hall    |     |     |
//   +-- --+-----+ ... +-----+-----+-----------+-----+-----+   14.4
//   |   +-----+-----+-----+-----+   +-----+-----+-----+   |
//   |   |     |     |     |     |   |     |     |     |   |
//   |   +-----+-----+-----+-----+   +-----+-----+-----+   |             west and east block
//   |   |     |     |     |     |   |     |     |     |   |
//   |   +-----+-----+-----+-----+   +-----+-----+-----+   |
//   +-----+-----+ ... +-----+-----+-----+-----+-----+-----+    0
//   |     |     |     |     |     |     |     |     |     |             rooms: south
//   +-----+-----+-----+-----+-----+-----+-----+-----+-----+   -5.8 m
//   0                           20  22.2                 46 m
//
// The route begins in the room at the lower left and goes around the west block, with detours into
// six rooms on its way, until it is back before that room.
Site makeCampus(unsigned seed)
{
  Building building(seed);
  const std::size_t southSide = building.addFrontage({0, 0}, {kLength_m, 0});
  const std::size_t eastSide = building.addFrontage({kLength_m, 0}, {kLength_m, kHeight_m});
  const std::size_t northSide = building.addFrontage({kLength_m, kHeight_m}, {0, kHeight_m});
  const std::size_t westSide = building.addFrontage({0, kHeight_m}, {0, 0});
  for (const std::size_t side : {eastSide, westSide}) building.addClosedDoor(side, kHeight_m / 2);
  const std::size_t south = building.addRooms(southSide, kOuterRoomDepth_m, ">-<<-<>->", 0, true);
  const std::size_t north = building.addRooms(northSide, kOuterRoomDepth_m, "<-><-H<-", 0, true);
  const Block west = addBlock(building, kCorridor_m, kCrossing_m, "->-<", "<->-");
  addBlock(building, kCrossing_m + kCorridor_m, kLength_m - kCorridor_m, "<-><-", "-<->-");

  const std::size_t hall = north + 3;
  addPillars(building, building.room(hall));
  const Route route = roundTrip(building, south, {west.south + 1, south + 1, south + 2},
                                {hall, west.north + 1, north + 4});
  return building.furnished(route, kWalls);
}
}  // namespace psmks
