/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Building.h>
#include <psmks/sim/Office.h>

namespace psmks
{
namespace
{
constexpr std::size_t kWalls = 139;
constexpr double kLength_m = 20, kHalfCorridor_m = 0.9, kRoomDepth_m = 4.15;
}  // namespace

//   +------+------+------+------+------+   5.05 m    rooms: north 4 3 2 1 0
//   |      |      |      |      |      |
//   +-- ---+-- ---+-- ---+--- --+--- --+   0.9
//     corridor                             0
//   +----- --+-- -----+----- --+-- ----+  -0.9
//   |        |        |        |       |             rooms: south 0 1 2 3
//   +--------+--------+--------+-------+  -5.05 m
//   0                                  20 m
//
// The route begins in the room at the upper left, goes along the corridor, once around each of five
// rooms, and back.
Site makeOffice(unsigned seed)
{
  Building building(seed);
  const double y_m = kHalfCorridor_m;
  const std::size_t southSide = building.addFrontage({0, -y_m}, {kLength_m, -y_m});
  building.addFrontage({kLength_m, -y_m}, {kLength_m, y_m});
  const std::size_t northSide = building.addFrontage({kLength_m, y_m}, {0, y_m});
  building.addFrontage({0, y_m}, {0, -y_m});
  const std::size_t south = building.addRooms(southSide, kRoomDepth_m, "><><", 0, false);
  const std::size_t north = building.addRooms(northSide, kRoomDepth_m, "<<>>>", 0, false);

  const Route home = building.room(north + 4).visit(kHalfCorridor_m);
  Route route{home[1], home[0]};
  for (const std::size_t room : {south + 1, north + 2, north + 0, south + 3, south + 0})
  {
    const Route detour = building.room(room).visit(kHalfCorridor_m);
    route.insert(route.end(), detour.begin(), detour.end());
  }
  route.insert(route.end(), {home[0], home[1]});
  return building.furnished(route, kWalls);
}
}  // namespace psmks
