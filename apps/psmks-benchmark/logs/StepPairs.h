/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Guesses.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <psmks/motion/OdometryNoise.h>

#include <vector>

namespace psmks
{
/** Scans of a log that follow each other, as pairs with their true motion. */
struct StepPairs
{
  std::vector<ScanPair> pairs;  //!< id: place of the current scan in the log
  Guesses odometry;             //!< with the covariance that its model states
  int withoutTruth = 0;         //!< left out: the truth was not measured at one of the scans
  int withoutOverlap = 0;       //!< left out: see kLeastOverlap
};

/** Pairs that share less of their rays at the true motion have nothing to be matched by. */
constexpr double kLeastOverlap = 1.0 / 3;

/** The pairs of a log of which only every so many scans were kept; none without a ground truth.
 *  @param every >= 1 */
StepPairs stepPairs(const Log& log, int every, const OdometryOptions& odometry);
}  // namespace psmks
