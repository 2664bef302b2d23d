/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PoseGraph.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace psmks
{
/** Writes a graph of poses in the text format of g2o, which gtsam and MRPT's graph-slam read, too:
 * a line VERTEX_SE2 for every node and a line EDGE_SE2 for every link. Lengths are in metres,
 * angles in radians.
 *
 *     VERTEX_SE2 name x y phi
 *     EDGE_SE2 from to x y phi  I_xx I_xy I_xphi I_yy I_yphi I_phiphi
 *
 * The information matrix of an edge is that in the axes of the measured pose of `to`, as g2o
 * defines it, times PoseGraph::weight() of the link. A program that minimises the plain sum of
 * squares then finds the poses where the robust cost of the graph has its minimum.
 * All matrices can be inverted: in directions that a link leaves open, 1e-4 stands in them.
 *  @param names the number that each node has in the file, such as the index of its scan; one for
 *      each node */
void writeG2o(std::ostream& out, const PoseGraph& graph, const std::vector<std::size_t>& names);
}  // namespace psmks
