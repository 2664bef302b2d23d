/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/sim/PairSets.h>

#include <vector>

namespace psmks
{
/** The pairs of a generated set as matchers get them, in their order. Scans of a moving sensor are
 * deskewed as those of a log are, with the velocity that the odometry measured. */
std::vector<ScanPair> scanPairs(const PairSet& set);
}  // namespace psmks
