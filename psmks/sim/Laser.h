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
/** A simulated laser scanner and its errors. */
struct LaserOptions
{
  BeamGrid grid = BeamGrid::centered(kPi, 181);
  double maxRange_m = 8;
  double rangeSigma_m = 0.01;       //!< standard deviation of the Gaussian noise of a range
  double rangeSigmaPerMetre_m = 0;  //!< growth of the noise, see RangeNoise
  double quantum_m = 0;             //!< ranges are multiples of it; 0 = exact
  double dropOutShare = 0;          //!< share of the returns that are lost, 0 to 1
  int returnEvery = 1;              //!< only every so many-th ray returns; 1 = all of them
  double beamDivergence_rad = 0;    //!< full width of a beam, which returns the mean range of all
                                    //!< that it meets, at edges a mixed pixel; 0 = thin
  int smoothedRays = 1;             //!< each noise is the mean of so many independent ones, scaled
                                    //!< to rangeSigma_m: neighbours err together; 1 = white
  double scanOffsetSigma_m = 0;     //!< of an offset of all ranges of a scan
  double scanBearingSigma_rad = 0;  //!< of an offset of all bearings of a scan
  double sweepDuration_s = 0;       //!< from first to last ray, which all have their own pose
  int interleavedTurns = 1;         //!< turns of the beam that share the rays, see Scan
  double turn_s = 0;                //!< from turn to turn

  /** From the first to the last of all rays. */
  double duration_s() const { return sweepDuration_s + (interleavedTurns - 1) * turn_s; }

  RangeNoise rangeNoise() const { return {rangeSigma_m, rangeSigmaPerMetre_m}; }
};

/** A scan with its true noise and the objects that its rays met. */
struct SimulatedScan
{
  Scan scan;                    //!< range 0 = no return
  std::vector<double> noise_m;  //!< measured minus true range of each ray, in the direction that it
                                //!< took; 0 without return
  std::vector<int> objectOfRay;  //!< see Hit::object; Hit::kNothing without return
  double bearingOffset_rad = 0;  //!< of the directions that the rays took from their bearings
};

/** The pose of the sensor at a time after the first ray. */
using SensorMotion = std::function<Pose2(double sinceFirstRay_s)>;

/** Casts a scan whose first ray leaves at time_s since the start. The stamp of the scan is left to
 * the caller.
 *  @param random used by nothing else, so that the same seed gives the same scan */
SimulatedScan castScan(const Surroundings& surroundings, const SensorMotion& T_world_sensor,
                       double time_s, const LaserOptions& laser, std::mt19937_64& random);

/** Casts a scan from a sensor at rest. */
SimulatedScan castScan(const Surroundings& surroundings, const Pose2& T_world_sensor,
                       const LaserOptions& laser, std::mt19937_64& random);
}  // namespace psmks
