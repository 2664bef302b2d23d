/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/DepthEdges.h>
#include <psmks/match/JointProblem.h>

#include <vector>

namespace psmks
{
/** Pairs the depth edges of two scans at a pose. Two edges are a pair if each is the nearest one to
 * the other of those whose objects end on the same side, and they are within the gate.
 *
 * A pair is held together across the line of sight to the reference edge, and not along it: the
 * surfaces of both objects say more of that.
 *
 * Differs from the paper: it pairs segments alone.
 *
 *  @param gate_m largest distance of the edges
 *  @param[in,out] pairs the pairs are appended to it
 *  @return the number of pairs, each of one ray on either object */
int pairEdges(const std::vector<DepthEdge>& reference, const std::vector<DepthEdge>& current,
              const Pose2& T_ref_cur, double gate_m, std::vector<RayTerm>& pairs);
}  // namespace psmks
