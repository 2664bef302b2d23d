/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Guesses.h>
#include <apps/psmks-benchmark/logs/LogInput.h>
#include <psmks/motion/OdometryNoise.h>

#include <vector>

namespace psmks
{
/** Consecutive scans of a log as pairs with their true motion. */
struct StepPairs
{
  std::vector<ScanPair> pairs;  //!< the id is the index of the current scan in the log
  Guesses odometry;             //!< with the covariance of the odometry model
  int withoutTruth = 0;         //!< number left out because a scan has no measured truth
  int withoutOverlap = 0;       //!< number left out by kLeastOverlap
};

/** Pairs are left out if the scans share a smaller part of their rays at the true motion. */
constexpr double kLeastOverlap = 1.0 / 3;

/** The pairs of consecutive scans after keeping one of so many scans; none without a ground truth.
 *  @param every >= 1 */
StepPairs stepPairs(const Log& log, int every, const OdometryOptions& odometry);
}  // namespace psmks
