/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

namespace psmks
{
/** A floor of nine rooms along a corridor, see makeSite(). */
Site makeOffice(unsigned seed);
}  // namespace psmks
