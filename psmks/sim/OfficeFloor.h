/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

namespace psmks
{
/** An office floor of 32 x 20 m with 24 furnished rooms along two corridors, which a third one
 * joins. The same seed gives the same floor. */
Site makeOfficeFloor(unsigned seed);
}  // namespace psmks
