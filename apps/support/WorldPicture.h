/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/sim/Route.h>
#include <psmks/sim/World.h>

#include <string>
#include <vector>

namespace psmks
{
/** What is drawn of a simulated drive; all but the world may be empty. */
struct WorldPicture
{
  std::string title;  //!< first line of the legend
  World world;
  Route route;              //!< to be followed
  std::vector<Pose2> path;  //!< driven in truth
};

/** Draws walls and points dark, moving objects with their paths, route, driven path, a bar for the
 * scale and a legend. North-up: x to the right, y up; the scale is that of saveMapPicture().
 *  @return false where the file cannot be written or there is nothing to draw */
bool saveWorldPicture(const WorldPicture& picture, const std::string& path);
}  // namespace psmks
