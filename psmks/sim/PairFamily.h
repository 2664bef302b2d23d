/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Laser.h>
#include <psmks/sim/Worlds.h>

#include <string>
#include <vector>

namespace psmks
{
/** A kind of generated scan pairs: where, with which scanner, how far apart. */
struct PairFamily
{
  std::string name;
  std::string description;  //!< one line
  LaserOptions laser;
  double maxTranslation_m = 0.5;              //!< between the two scans, in any direction
  double maxRotation_rad = degToRad(15);      //!< either way
  int people = 0;                             //!< around, who move between the two scans
  Site (*makeSite)(unsigned seed) = nullptr;  //!< its route is not used

  /** Of a range, rounding to the quantum included. */
  RangeNoise rangeNoise() const;
};

/** All of them: the plain ones, then the harder ones.
 *
 * Scanners: `L180`: 361 rays over 180 degrees, 30 m (SICK LMS 200 at half a degree); `L180r8`: the
 * same, 8 m; `L360`: 360 rays all round, 30 m; `urg04lx` and others: those of config/sensors, with
 * their noise. Displacements: `small` to 0.15 m and 5 degrees,
 * `medium` 0.5 m and 15, `large` 1 m and 20; where the name does not say, it is medium. The noise
 * is 1 cm and the worlds are office floors of 32 x 20 m where nothing else is said. */
const std::vector<PairFamily>& pairFamilies();

/** The family of a name, or null. */
const PairFamily* findPairFamily(const std::string& name);

/** @throws std::invalid_argument naming the known ones for a name that is not known */
const PairFamily& pairFamily(const std::string& name);
}  // namespace psmks
