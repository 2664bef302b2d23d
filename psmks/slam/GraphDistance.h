/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PoseGraph.h>

#include <vector>

namespace psmks
{
/** Length of the shortest way along links from one node to each, in metres: what has been driven,
 * or matched, since the one place was left for the other, and with it how far the two may have
 *  drifted apart. Infinite where no way leads. */
std::vector<double> graphDistances_m(const PoseGraph& graph, std::size_t from);
}  // namespace psmks
