/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/Segment.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Finds straight lines through too few rays for a segment, such as a distant wall that is seen
 * between two nearer objects (docs/derivations.md, "Short lines").
 *
 *       o----o----o         A short line is seen by 3 consecutive rays or more. It is longer than
 *         \  |  /           a leg or a pillar is wide, and the rays lie on it within their noise.
 *          scanner
 *
 * Three points of different objects rarely lie on one line. A curve that bends less than the noise
 * over such a length may pass for straight.
 *
 * Differs from the paper: there such rays are single points, which are not matched. Seen through
 * clutter, most walls are short lines.
 *
 *  @param circleOfRay index of the circle of each ray; rays that have one, which is not negative,
 * are left out, see findCircles()
 *  @param[out] lines in the order of their rays, which stay without a segment in the scan; what it
 * held is replaced */
void findShortLines(const SegmentedScan& scan, const std::vector<int>& circleOfRay,
                    std::vector<Segment>& lines);
}  // namespace psmks
