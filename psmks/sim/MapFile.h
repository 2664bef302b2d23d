/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

#include <istream>
#include <stdexcept>

namespace psmks
{
/** A map that cannot be read. The text gives the number of the line and the reason. */
class MapFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Reads an ActivMedia map (MobileRobots `.map`). Its millimetres are converted to metres, the
 * entries of the section LINES to walls, those of DATA to points. The robot starts at RobotHome, or
 * at the origin if the file has no such entry. Unknown headers, CRLF, empty sections and wrong
 * counts are accepted.
 *  @throws MapFileError if the file is not such a map or a row has too few numbers */
Site readMapFile(std::istream& in);
}  // namespace psmks
