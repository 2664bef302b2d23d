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

  /** With that of rounding, which the rays do not show: on a wall ahead all are rounded alike. */
  RangeNoise addedTo(RangeNoise noise) const;
};

/** The step whose multiples the ranges of a scan are.
 *
 * Either exactly, as a scanner with coarse units sends them, or beneath noise that was added
 * afterwards: MRPT's simulator marches along a ray through a grid map, by 0.8 cells at a time,
 * until it stands in an occupied cell. Such ranges draw a wall as arcs about the scanner, as quiet
 * as the noise, that go along with the robot instead of staying with the wall; and they end behind
 * it, by half a step on average.
 *
 *     ----.                wall; the rays that end on an arc have one range
 *          '--.
 *     s        '--.        steps of 6 to 20 cm are found beneath noise of up to a tenth of them
 *
 * Steps that are fine beside the noise that the rays are said to have are left out. */
RangeRounding findRounding(const RaySoA& rays);
}  // namespace psmks
