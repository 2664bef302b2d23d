/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Simulation.h>
#include <psmks/sim/Worlds.h>

#include <functional>
#include <string>

namespace psmks
{
/** Which drive an experiment is made on. */
struct DrivePlan
{
  std::string site;  //!< see makeSite()
  unsigned seed = 1;
  double maxRange_m = 30;
  double duration_s = 600;
};

/** A drive in a simulated world: the same for every method. */
struct Drive
{
  DrivePlan plan;
  Site site;
  SimulationOptions simulation;
  Recording recording;
};

/** Along the route where the site has one, else wherever the Area Center driver goes. */
Drive makeDrive(const DrivePlan& plan, const std::function<void(double)>& progress = nullptr);
}  // namespace psmks
