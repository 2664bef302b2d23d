/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Route.h>
#include <psmks/sim/World.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** A world with the pose at which a robot starts and, for drives by hand, a route. */
struct Site
{
  World world;
  Pose2 T_world_start;
  std::optional<Route> route;  //!< for drives by hand (office, campus, kilometres)
};

/** The names that makeSite() accepts. */
std::vector<std::string> siteNames();

/** Makes a world. All but the last are like one of the paper's, with the same numbers of walls and
 * points. The same seed gives the same world.
 *
 *  - `room` (a): 32 walls: a room of 24 x 18 m with 7 boxes parallel to it
 *  - `clutter` (b): 130 walls: the same with 31 boxes at any angle and 2 free walls
 *  - `curved` (c): 130 walls and 15,114 points on round and thin objects, 33 x 25 m
 *  - `corridors` (d): 163 walls: corridors of 1.5 m around two blocks, with recesses, 34 x 20 m
 *  - `office`: 139 walls on 200 m^2, with a route of 94 m and 8 turns
 *  - `campus`: 507 walls on 1,200 m^2 with long corridors, with a route of 134 m and 10 turns
 *  - `kilometres`: corridors and halls, with a route of 1 km there and 1 km back for the first
 * seed, 2, 3, 4 and 5 km for the next four, then 1 km again
 *
 *  @throws std::invalid_argument for any other name; the text lists the known ones */
Site makeSite(const std::string& name, unsigned seed);
}  // namespace psmks
