/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

namespace psmks
{
/** How the ranges of a scan were rounded. */
struct RangeRounding
{
  double step_m = 0;       //!< the ranges are multiples of it; 0 = no coarse step is known
  double overshoot_m = 0;  //!< by which the ranges are too long on average

  /** A noise with the variance of the rounding added. The rays do not show that variance
   * themselves: on a wall straight ahead all of them are rounded alike. */
  RangeNoise addedTo(RangeNoise noise) const;
};

/** Finds the step whose multiples the ranges of a scan are (docs/derivations.md, "Range noise").
 *
 * The ranges are multiples either exactly, as a scanner with coarse units sends them, or beneath
 * noise that was added afterwards. The latter comes from MRPT's simulator, which marches along a
 * ray through a grid map by 0.8 cells at a time until it stands in an occupied cell. Such ranges
 * draw a wall as arcs about the scanner. The arcs are as quiet as the noise, and move with the
 * robot instead of staying with the wall. They end behind the wall, by half a step on average.
 *
 *     ----.                wall; the rays that end on one arc have one range
 *          '--.
 *     s        '--.        steps of 6 to 20 cm are found beneath noise of up to a tenth of them
 *
 *  @param rays the columns of a scan; a step that is small beside `rays.noise` does not count
 *  @return the step, or a RangeRounding of zeros where there is none */
RangeRounding findRounding(const RaySoA& rays);
}  // namespace psmks
