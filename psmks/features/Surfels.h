/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Finds surfels: short pieces of line through rays that are on no other line, such as those on
 * arcs of pillars, door jambs and rough objects.
 *
 *        o o            A surfel has 3 rays or more, and is not longer than 25 cm.
 *      o     o
 *     o       o
 *
 * The surface is not straight. The variance of a surfel's distance is therefore that of its rays
 * and 1 cm squared.
 *
 * Differs from the paper: there single points are not matched. In places with few straight walls
 * they are most of what can be matched.
 *
 *  @param[in,out] lines the surfels are appended to it
 *  @param[in,out] lineOfRay index into `lines` for every ray, or -1; set for the rays of surfels */
void appendSurfels(const SegmentedScan& scan, std::vector<AnchoredLine>& lines,
                   std::vector<int>& lineOfRay);
}  // namespace psmks
