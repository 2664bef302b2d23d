/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** Flags the rays on small free-standing objects, such as a person, a chair or a cart, which may
 * have moved between two scans.
 *
 *      --------   --------   wall
 *             . o .          object: consecutive rays, not wider than a person with a bag, and
 *              \|/           clearly nearer than what is seen to their left and right
 *            scanner
 *
 * A wall looks like this only where no more than 0.8 m of it is seen and both ends drop behind by
 * 0.3 m or more, such as a pillar or a pier between two open doors: its rays are flagged too.
 *
 * Differs from the paper: it knows no movable objects.
 *
 *  @param[out] movable one flag per ray, 0 or 1; what it held is replaced */
void findMovableObjects(const SegmentedScan& scan, std::vector<std::uint8_t>& movable);
}  // namespace psmks
