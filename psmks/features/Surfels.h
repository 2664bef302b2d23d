/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Short pieces of line through the rays that belong to no segment: arcs of pillars, door jambs,
 * rough objects.
 *
 *        o o            cut into pieces not longer than 25 cm, of 3 rays or more
 *      o     o
 *     o       o
 *
 * They are not straight; their distance counts as known to the noise and 1 cm of shape.
 *
 * Differs from the paper: there single points are not matched. In places with few straight walls
 * they are most of what can be matched.
 *
 * @param[in,out] lines the patches are appended
 * @param[in,out] lineOfRay index into lines of every ray, or -1; set for the rays of patches */
void appendSurfels(const SegmentedScan& scan, std::vector<AnchoredLine>& lines,
                   std::vector<int>& lineOfRay);
}  // namespace psmks
