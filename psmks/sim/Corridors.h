/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

namespace psmks
{
/** Narrow corridors around two blocks with closed doors in recesses, see makeSite(). */
Site makeCorridors(unsigned seed);
}  // namespace psmks
