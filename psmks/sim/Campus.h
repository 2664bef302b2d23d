/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

namespace psmks
{
/** A floor of a large building: long corridors around two blocks of rooms, see makeSite(). */
Site makeCampus(unsigned seed);
}  // namespace psmks
