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
/** A set of scan pairs with what every matcher made of it. */
struct PairsSetResult
{
  std::string title;
  std::vector<ScanPair> pairs;
  std::vector<PairBound> bounds;  //!< one per pair; empty where they are not known
  std::vector<PairsRun> runs;     //!< one per matcher and guess; records one per pair, in order
  bool hasMovingObjects = false;
  PairError successLimit = kSuccessLimit;
  std::vector<Panel> convergence;  //!< areas of convergence; empty where they were not measured
};

/** A row for each run.
 *  @param baseline see pairsTable() */
Table tableOf(const PairsSetResult& set, const std::string& baseline);

/** The bounds and runs of all sets without moving objects as one, without its pairs. */
PairsSetResult pooledStaticSets(const std::vector<PairsSetResult>& sets);
}  // namespace psmks
