/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/motion/PlanarVelocity.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/Worlds.h>

#include <string>
#include <vector>

namespace psmks
{
/** A kind of generated scan pairs: the world, the scanner and the displacement. */
struct PairFamily
{
  std::string name;
  std::string description;  //!< one line
  LaserOptions laser;
  double maxTranslation_m = 0.5;          //!< largest distance of the two scans, in any direction
  double maxRotation_rad = degToRad(15);  //!< largest rotation, in either direction
  PlanarVelocity fastest{};               //!< of the sensor while it takes a scan, in either sense
  int people = 0;                         //!< number of people, who move between the two scans
  Site (*makeSite)(unsigned seed) = nullptr;  //!< its route is not used

  /** The noise of a range, including the rounding to the quantum. */
  RangeNoise rangeNoise() const;

  /** White noise of which as many rays tell as much as those of the scanner. */
  RangeNoise equivalentWhiteNoise() const;
};

/** All families: first the plain ones, then those with one difficulty more.
 *
 * Scanners: `L180`: 361 rays over 180 degrees, 30 m (SICK LMS 200 at half a degree); `L180r8`: the
 * same, 8 m; `L360`: 360 rays all round, 30 m; `urg04lx` and others: those of config/sensors, with
 * their noise. Displacements: `small` is up to 0.15 m and 5 degrees, `medium` 0.5 m and 15 degrees,
 * `large` 1 m and 20 degrees. Unless the name or the description says otherwise, the displacement
 * is medium, the noise is 1 cm, and the worlds are office floors of 32 x 20 m. */
const std::vector<PairFamily>& pairFamilies();

/** The family of a name, or null if there is none. */
const PairFamily* findPairFamily(const std::string& name);

/** The family of a name.
 *  @throws std::invalid_argument if there is none; the text lists all names */
const PairFamily& pairFamily(const std::string& name);
}  // namespace psmks
