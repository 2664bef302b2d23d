/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** The scan that a scanner which looks all round would take at a pose, of what scans around it saw.
 *
 *      a \     | wall        Neighbouring returns of a scan that lie close together are joined. A
 * ray \    |             of the view meets the joins of all scans; the nearest counts, and what
 *     -----o===+==           other scans saw within 15 cm behind it is averaged with it, for it is
 *         /    |             the same surface, moved by the errors of ranges and poses. A ray that
 *      b /     |             meets the back of a surface first has no return: what the front of the
 *                            surface looks like from here, no scan has seen.
 *
 * Two views of the same place from different scans show the same surfaces in whatever direction the
 * scanner looked, so that a robot which comes back the other way recognises the place.
 *
 *  @param members indices of the scans, whose poses have to fit each other to some centimetres
 *  @param T_world_view where the view is taken; its x axis is that of the view
 *  @return as many rays all round as the first of these scans has for its field of view; without a
 * valid ray where there are no scans. The standard deviation of a range is that of the first scan.
 */
Scan localView(const std::vector<PosedScan>& scans, const std::vector<std::size_t>& members,
               const Pose2& T_world_view);
}  // namespace psmks
