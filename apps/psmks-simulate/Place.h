/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-simulate/CommandLine.h>
#include <psmks/sim/Route.h>
#include <psmks/sim/World.h>

#include <memory>
#include <string>

namespace psmks
{
/** Where a drive takes place, from whatever source. */
struct Place
{
  std::unique_ptr<Surroundings> surroundings;  //!< people included
  World drawn;                                 //!< what a picture shows of them
  std::string contents;                        //!< "32 walls, 0 points"
  Pose2 T_world_start;
  Route route;  //!< empty: none
};

/** Finds the world and the route that a command line names, and puts the robot and the people
 * there.
 *  @throws ProgramError for a world or a route that is missing or damaged, and where the robot does
 *  not fit in at its start */
Place loadPlace(const CommandLine& commandLine, double robotRadius_m);
}  // namespace psmks
