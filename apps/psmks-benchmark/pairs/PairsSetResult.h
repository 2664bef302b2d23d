/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>
#include <psmks/eval/PairBound.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>

#include <string>
#include <vector>

namespace psmks
{
/** A set of scan pairs with the results of all matchers. */
struct PairsSetResult
{
  std::string title;
  std::vector<ScanPair> pairs;
  std::vector<PairBound> bounds;  //!< one for each pair; empty if they are unknown
  std::vector<PairsRun> runs;     //!< one for each matcher and guess, with a record for each pair
  bool hasMovingObjects = false;
  PairError successLimit = kSuccessLimit;
  std::vector<Panel> convergence;  //!< areas of convergence; empty if they were not measured
};

/** The table of a set, with a row for each run.
 *  @param baseline see pairsTable() */
Table tableOf(const PairsSetResult& set, const std::string& baseline);

/** The bounds and runs of all sets without moving objects as one set, without the pairs. */
PairsSetResult pooledStaticSets(const std::vector<PairsSetResult>& sets);
}  // namespace psmks
