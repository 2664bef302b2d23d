/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>

#include <string>

namespace psmks
{
/** Draws a map: overlaid points light, segments dark, the path coloured from start to end, what
 * odometry alone gives dashed, a bar for the scale and a legend. North-up: x to the right, y up.
 *
 *  2 cm a pixel, but the longer side has 1200 to 4000 pixels. The few farthest points are left
 * out of the frame.
 *  @param title first line of the legend
 *  @return false where the file cannot be written or the map is empty */
bool saveMapPicture(const ScanMap& map, const std::string& title, const std::string& path);
}  // namespace psmks
