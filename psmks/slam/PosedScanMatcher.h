/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>
#include <psmks/slam/PreparedScans.h>

#include <memory>
#include <vector>

namespace psmks
{
/** Matches the scans of a trajectory against each other: poses go in and come out as those of the
 * robots, scans are prepared once, and every match is timed. */
class PosedScanMatcher
{
 public:
  explicit PosedScanMatcher(std::unique_ptr<PairMatcher> matcher);

  /** Matches one scan of a trajectory against another.
   *  @param T_ref_cur guess of the robot at the current scan, seen from the robot at the reference;
   * it takes part as a measurement with its covariance
   *  @param scope how far from the guess the pose is searched for
   *  @return on failure the guess, with a result that is not usable */
  ReferenceMatch match(const std::vector<PosedScan>& scans, std::size_t reference,
                       std::size_t current, const UncertainPose& T_ref_cur,
                       SearchScope scope = SearchScope::Full);

 private:
  std::unique_ptr<PairMatcher> matcher_;
  PreparedScans prepared_;
};
}  // namespace psmks
