/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/ScanMap.h>

#include <iosfwd>
#include <string>

namespace psmks
{
/** Draws the segments of a map and the path as an SVG document: x to the right, y up, numbers in
 * metres at a grid, and below the map a legend. Texts are texts, and the segments and the path are
 * elements of their own, with the ids "segments" and "path", so that a drawing program can change
 * them. Of an empty map an empty sheet is drawn.
 *  @param title above the map */
void writeMapSvg(std::ostream& out, const ScanMap& map, const std::string& title);
}  // namespace psmks
