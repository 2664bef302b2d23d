/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/BeamGrid.h>

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
  double sweepDuration_s = 0;  //!< time from the first to the last ray, negative if the last one
                               //!< was measured first; 0 = simultaneous or unknown
};
}  // namespace psmks
