/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** One sweep of a 2D laser scanner, in the sensor frame: x forward, y left, bearings
 *  counter-clockwise. Nothing here is cleaned: see Preprocessing. */
struct Scan
{
  BeamGrid grid;
  std::vector<double> range_m;      //!< one per ray; anything, NaN and infinities included
  std::vector<std::uint8_t> valid;  //!< one per ray, 0 = flagged invalid; empty = none flagged
  double maxRange_m = 0;            //!< readings at or beyond it are no returns; 0 = no limit
  double rangeSigma_m = 0;          //!< standard deviation of a range; 0 = unknown
  double stamp_s = 0;               //!< seconds since the epoch, of the first ray
  double sweepDuration_s = 0;       //!< from the first to the last ray, negative where the last one
                                    //!< came first; 0 = at once or unknown
};
}  // namespace psmks
