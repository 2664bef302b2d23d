/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/sim/PairSets.h>

#include <vector>

namespace psmks
{
/** What matchers get of a generated set, in its order. */
inline std::vector<ScanPair> scanPairs(const PairSet& set)
{
  std::vector<ScanPair> pairs;
  for (const SimulatedPair& pair : set.pairs)
    pairs.push_back({pair.id, pair.T_ref_cur_true, pair.T_ref_cur_odometry, pair.reference.scan,
                     pair.current.scan});
  return pairs;
}
}  // namespace psmks
