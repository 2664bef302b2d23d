/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace psmks
{
/** One sweep of a 2D laser scanner in the sensor frame: x forward, y left, bearings
 * counter-clockwise. The ranges are as the scanner delivered them; Preprocessing decides which ones
 * are used. */
struct Scan
{
  BeamGrid grid;
  std::vector<double> range_m;      //!< one per ray; NaN and infinities are allowed
  std::vector<std::uint8_t> valid;  //!< one per ray, 0 = invalid; empty = no ray is flagged
  double maxRange_m = 0;       //!< readings at or beyond it are taken for no return; 0 = no limit
  double rangeSigma_m = 0;     //!< standard deviation of a range; 0 = unknown
  double stamp_s = 0;          //!< time of the first ray, seconds since the epoch
  double sweepDuration_s = 0;  //!< time in which the beam passes from the first to the last ray,
                               //!< negative if it comes to the last one first; 0 = simultaneous or
                               //!< unknown
  int interleavedTurns = 1;  //!< turns of the beam that took the scan: each takes every so many-th
                             //!< ray, the first turn the ray that the beam comes to first
  double turn_s = 0;         //!< time from turn to turn; 0 = unknown
};

/** Whether a scan has one range for each ray of its grid. */
inline bool isWellFormed(const Scan& scan)
{
  return scan.range_m.size() == static_cast<std::size_t>(scan.grid.count());
}

/** Whether a ray met something, by what the scan itself says of it.
 *  @param ray within the grid; the scan has as many ranges as its grid has rays */
inline bool isReturn(const Scan& scan, int ray)
{
  const auto i = static_cast<std::size_t>(ray);
  const double range_m = scan.range_m[i];
  const bool flaggedValid = scan.valid.size() != scan.range_m.size() || scan.valid[i] != 0;
  const bool inReach = scan.maxRange_m <= 0 || range_m < scan.maxRange_m;
  return flaggedValid && std::isfinite(range_m) && range_m > 0 && inReach;
}
}  // namespace psmks
