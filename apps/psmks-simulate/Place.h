/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-simulate/CommandLine.h>
#include <psmks/sim/Route.h>
#include <psmks/sim/World.h>

#include <memory>
#include <string>

namespace psmks
{
/** The world of a drive, its route and the start pose. */
struct Place
{
  std::unique_ptr<Surroundings> surroundings;  //!< including the people
  World drawn;                                 //!< the same for a picture
  std::string contents;                        //!< description such as "32 walls, 0 points"
  Pose2 T_world_start;
  Route route;  //!< empty if there is none
};

/** Loads the world and the route of a command line, and places the robot and the people.
 *  @throws ProgramError if a world or a route is missing or damaged, or if the robot has no
 *      space at its start */
Place loadPlace(const CommandLine& commandLine, double robotRadius_m);
}  // namespace psmks
