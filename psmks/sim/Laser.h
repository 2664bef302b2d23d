/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/RangeNoise.h>
#include <psmks/geometry/Scan.h>
#include <psmks/sim/Surroundings.h>

#include <functional>
#include <random>
#include <vector>

namespace psmks
{
/** A simulated laser scanner and what is wrong with it. */
struct LaserOptions
{
  BeamGrid grid = BeamGrid::centered(kPi, 181);
  double maxRange_m = 8;
  double rangeSigma_m = 0.01;       //!< Gaussian, of every return
  double rangeSigmaPerMetre_m = 0;  //!< its growth, see RangeNoise
  double quantum_m = 0;             //!< ranges are multiples of it; 0 = exact
  double dropOutShare = 0;          //!< share of the returns that are lost, 0 to 1
  double beamDivergence_rad = 0;    //!< full width of a beam: it returns the mean range of all that
                                    //!< it lights, at an edge a mixed pixel in the air; 0 = thin
  double sweepDuration_s = 0;       //!< from the first to the last ray, each from its own pose

  RangeNoise rangeNoise() const { return {rangeSigma_m, rangeSigmaPerMetre_m}; }
};

/** A scan of which the truth is known. */
struct SimulatedScan
{
  Scan scan;                     //!< range 0 = no return
  std::vector<double> noise_m;   //!< measured minus true range of each ray; 0 without return
  std::vector<int> objectOfRay;  //!< see Hit::object; Hit::kNothing without return
};

/** Pose of the sensor so many seconds after the first ray. */
using SensorMotion = std::function<Pose2(double sinceFirstRay_s)>;

/** A scan whose first ray leaves at time_s since the start; the stamp is left to the caller.
 *  @param random its own engine, so that the same seed gives the same scan */
SimulatedScan castScan(const Surroundings& surroundings, const SensorMotion& T_world_sensor,
                       double time_s, const LaserOptions& laser, std::mt19937_64& random);

/** The same from a sensor at rest. */
SimulatedScan castScan(const Surroundings& surroundings, const Pose2& T_world_sensor,
                       const LaserOptions& laser, std::mt19937_64& random);
}  // namespace psmks
