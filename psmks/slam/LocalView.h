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
 * ray \    |             of the view has the range of the nearest join that it meets of one
 *     -----o===+             scan: the first member that has a join along the ray. So the members
 *         /    |             nearest to the pose should come first. A ray that meets the back of a
 *      b /     |             surface has no return, for no scan has seen its front. Returns that
 *                            are joined to no other are left out.
 *
 * Two views of a place from different scans show the same surfaces in whatever direction the
 * scanner looked, so that a robot which comes back the other way recognises the place.
 *
 *  @param members indices of the scans, whose poses have to fit each other to some centimetres
 *  @param T_world_view where the view is taken; its x axis is that of the view
 *  @return a scan all round with the spacing of the rays and the standard deviation of a range of
 * the first member; without a valid ray where nothing was seen, and without rays where there are no
 * members */
Scan localView(const std::vector<PosedScan>& scans, const std::vector<std::size_t>& members,
               const Pose2& T_world_view);
}  // namespace psmks
