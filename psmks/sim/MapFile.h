/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

#include <istream>
#include <stdexcept>

namespace psmks
{
/** A map that cannot be read; the text holds the number of the line and the reason. */
class MapFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Reads an ActivMedia map (MobileRobots `.map`): millimetres become metres, the sections LINES and
 * DATA walls and points. The robot starts at RobotHome where the file has one, else at the origin.
 * Unknown headers, CRLF, empty sections and counts that disagree are accepted.
 *  @throws MapFileError */
Site readMapFile(std::istream& in);
}  // namespace psmks
