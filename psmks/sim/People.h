/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/MovingObject.h>
#include <psmks/sim/Surroundings.h>

#include <vector>

namespace psmks
{
/** Makes people who walk along straight lines between random points, clear of all obstacles, in the
 * area that can be reached on foot from a place. The same seed gives the same people.
 *  @return fewer people than wanted if there is not enough space to walk */
std::vector<MovingObject> peopleAround(const Surroundings& surroundings,
                                       const Eigen::Vector2d& place_m, int count, unsigned seed);
}  // namespace psmks
