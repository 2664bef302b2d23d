/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/sim/Route.h>
#include <psmks/sim/World.h>

#include <string>
#include <vector>

namespace psmks
{
/** The content of a picture of a simulated drive. All except the world may be empty. */
struct WorldPicture
{
  std::string title;  //!< above the picture
  World world;
  Route route;              //!< the route to follow
  std::vector<Pose2> path;  //!< the true path
};

/** Draws walls and points dark, the moving objects with their paths, the route and the driven path;
 * around them the title, numbers in metres and a legend. For directions and resolution see
 * MapSheet.
 *  @return false if the file cannot be written or there is nothing to draw */
bool saveWorldPicture(const WorldPicture& picture, const std::string& path);
}  // namespace psmks
