/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/Segment.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Straight lines through too few rays for a segment: a wall far away, seen between two nearer
 * things.
 *
 *       o----o----o         3 rays or more in a row, farther apart than the width of a leg or a
 *         \  |  /           pillar, on one line to the noise
 *          scanner
 *
 * Three points of different things rarely lie on a line, and a curve that bends less than the noise
 * over such a length is straight for every purpose here.
 *
 * Differs from the paper: there such rays are single points, which are not matched. Seen through
 * clutter, most walls are short lines.
 *
 * @param circleOfRay rays with one are left alone, see findCircles()
 * @param[out] lines in the order of their rays, which stay without a segment in the scan */
void findShortLines(const SegmentedScan& scan, const std::vector<int>& circleOfRay,
                    std::vector<Segment>& lines);
}  // namespace psmks
