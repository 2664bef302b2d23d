/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Scan.h>
#include <psmks/sim/World.h>

#include <random>
#include <vector>

namespace psmks
{
/** A simulated laser scanner. */
struct Scanner
{
  BeamGrid grid = BeamGrid::centered(kPi, 181);
  double maxRange_m = 8;
  double rangeSigma_m = 0.01;  //!< Gaussian, of every return
};

/** A scan of which the truth is known. */
struct SimulatedScan
{
  Scan scan;                   //!< range 0 = no return
  std::vector<int> wallOfRay;  //!< index into World::walls(), or World::Hit::kNothing
};

SimulatedScan castScan(const World& world, const Pose2& T_world_sensor, const Scanner& scanner,
                       std::mt19937_64& random);
}  // namespace psmks
