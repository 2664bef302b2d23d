/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/MovingObject.h>
#include <psmks/sim/Surroundings.h>

#include <vector>

namespace psmks
{
/** People who walk where one can get to from a place, on straight ways between points that they
 * chose at random, past everything that stands there. The same seed gives the same people.
 *  @return fewer than asked for where there is no room to walk */
std::vector<MovingObject> peopleAround(const Surroundings& surroundings,
                                       const Eigen::Vector2d& place_m, int count, unsigned seed);
}  // namespace psmks
