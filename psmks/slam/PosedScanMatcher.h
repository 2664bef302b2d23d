/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>
#include <psmks/slam/PreparedScans.h>

#include <memory>
#include <vector>

namespace psmks
{
/** The covariance of a guess that is where a match starts, and no measurement: 0.5 m and 10
 * degrees. It pulls the result by (sigma of the scans / 0.5 m)^2 of its own error: 0.2 mm where the
 * scans know a direction to 15 mm and the guess is 0.2 m off. */
Eigen::Matrix3d vagueCovariance();

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

  /** Matches two views of local maps (LocalView.h), which are scans in the frames of robots, within
   *  SearchScope::WithinCovariance.
   *  @param reference stated in the result
   *  @param T_ref_cur the guess, of the two views */
  ReferenceMatch matchViews(std::size_t reference, const Scan& viewRef, const Scan& viewCur,
                            const UncertainPose& T_ref_cur);

 private:
  std::unique_ptr<PairMatcher> matcher_;
  PreparedScans prepared_;
};
}  // namespace psmks
