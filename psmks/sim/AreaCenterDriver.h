/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>

#include <random>

namespace psmks
{
struct AreaCenterOptions
{
  double gain = 0.5;          //!< of the speed: 1.2 m/s times it in open space
  double initialReach_m = 5;  //!< ranges are clipped to the reach
};

/** Drives where the free space is: toward the centre of the area the scanner sees (the paper's
 * roaming driver, the Area Center method of Alvarez-Sanchez et al. 2010; docs/algorithm.md,
 * "Simulation"). Never ends. */
class AreaCenterDriver : public Driver
{
 public:
  /** @param seed of the choices between two ways */
  AreaCenterDriver(const AreaCenterOptions& options, const RobotOptions& robot, unsigned seed);

  WheelSpeeds drive(const DriverView& view) override;
};
}  // namespace psmks
