/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Worlds.h>

namespace psmks
{
/** About the length of the shortest way from the start of makeKilometres() to its other end. */
constexpr double kShortestWay_m = 1000;

/** A way of kilometres through corridors and halls, there and back, see makeSite(). A scanner that
 * looks ahead only sees everything on the way back from the other side. */
Site makeKilometres(unsigned seed);
}  // namespace psmks
