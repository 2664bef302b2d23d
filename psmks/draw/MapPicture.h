/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>

#include <string>

namespace psmks
{
/** Draws a map: the points of all scans in a light colour, the segments dark, the path coloured
 * from start to end, the path of odometry alone dashed; around the map its title, numbers in metres
 * and a legend. For directions and resolution see MapSheet. The frame leaves out the few farthest
 * points.
 *  @param title above the map
 *  @return false if the file cannot be written or the map is empty */
bool saveMapPicture(const ScanMap& map, const std::string& title, const std::string& path);
}  // namespace psmks
