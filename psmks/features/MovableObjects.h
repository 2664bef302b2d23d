/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** Flags the rays on free-standing small objects: consecutive rays, not wider than a person with a
 * bag, with everything seen beside them clearly farther away.
 *
 *      --------   --------   wall
 *             . o .          object: nearer than what is left and right of it
 *              \|/
 *            scanner
 *
 * Such an object - a person, a chair, a cart - may have moved between two scans. Walls and their
 * corners never look like this. */
void findMovableObjects(const SegmentedScan& scan, std::vector<std::uint8_t>& movable);
}  // namespace psmks
