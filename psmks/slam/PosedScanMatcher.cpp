/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/slam/PosedScanMatcher.h>

#include <utility>

namespace psmks
{
PosedScanMatcher::PosedScanMatcher(std::unique_ptr<PairMatcher> matcher)
    : matcher_(std::move(matcher)), prepared_(*matcher_)
{
}

ReferenceMatch PosedScanMatcher::match(const std::vector<PosedScan>& scans, std::size_t reference,
                                       std::size_t current, const UncertainPose& T_ref_cur,
                                       SearchScope scope)
{
  const Pose2& mountingRef = scans[reference].T_robot_sensor;
  const Pose2& mountingCur = scans[current].T_robot_sensor;
  const UncertainPose guess = conjugated(T_ref_cur, mountingRef.inverse(), mountingCur.inverse());

  Stopwatch stopwatch;
  const auto preparedRef = prepared_.find(reference, scans[reference].scan);
  const auto preparedCur = prepared_.find(current, scans[current].scan);
  const double preparation_s = stopwatch.lap_s();

  ReferenceMatch match;
  match.reference = reference;
  match.result = matcher_->matchPrepared(*preparedRef, *preparedCur,
                                         Guess{guess.pose, guess.covariance}, scope);
  match.result.times.segmentation_s += preparation_s;
  match.time_s = preparation_s + stopwatch.lap_s();
  match.T_ref_cur =
      conjugated({match.result.T_ref_cur, match.result.covariance}, mountingRef, mountingCur);
  return match;
}
}  // namespace psmks
