/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/OccupancyGrid.h>

#include <iosfwd>
#include <string>

namespace psmks
{
/** \file
 * An occupancy grid as the two files that the map servers of ROS 1 and 2 (nav2) read: a picture and
 * what it means. MRPT reads them by COccupancyGridMap2D::FromROSMapServerYAML(). */

/** Writes the picture, a binary PGM with a pixel for each cell, the highest y first: free 254,
 * occupied 0, unknown 128. Map servers take 128 for unknown, as they do 205, the value that theirs
 * write; MRPT, which takes a pixel for a probability, understands 128 only. */
void writeMapServerPicture(std::ostream& out, const OccupancyGrid& grid);

/** Writes what the picture means: size of a pixel in m, place of its lower left corner in m, and
 * the thresholds between the three values.
 *  @param pictureFile name of the picture, in the same folder */
void writeMapServerYaml(std::ostream& out, const OccupancyGrid& grid,
                        const std::string& pictureFile);
}  // namespace psmks
