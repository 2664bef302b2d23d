/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/sim/PairSets.h>

#include <vector>

namespace psmks
{
/** The pairs of a generated set as matchers get them, in their order. */
inline std::vector<ScanPair> scanPairs(const PairSet& set)
{
  std::vector<ScanPair> pairs;
  for (const SimulatedPair& pair : set.pairs)
    pairs.push_back({pair.id, pair.T_ref_cur_true, pair.T_ref_cur_odometry, pair.reference.scan,
                     pair.current.scan});
  return pairs;
}
}  // namespace psmks
