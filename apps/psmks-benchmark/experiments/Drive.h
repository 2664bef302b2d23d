/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Simulation.h>
#include <psmks/sim/Worlds.h>

#include <functional>
#include <string>

namespace psmks
{
/** The choice of a drive for an experiment. */
struct DrivePlan
{
  std::string site;  //!< see makeSite()
  unsigned seed = 1;
  double maxRange_m = 30;
  double duration_s = 600;
  int people = 0;  //!< so many walk about
};

/** A drive in a simulated world, which is the same for all methods. */
struct Drive
{
  DrivePlan plan;
  Site site;
  SimulationOptions simulation;
  Recording recording;
};

/** Simulates a drive. The robot follows the route of the site; if there is none, the Area Center
 * driver steers. */
Drive makeDrive(const DrivePlan& plan, const std::function<void(double)>& progress = nullptr);
}  // namespace psmks
