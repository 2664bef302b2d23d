/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/slam/PosedScanMatcher.h>

#include <utility>

namespace psmks
{
namespace
{
/** What a match adds to the covariance that its guess had. */
Eigen::Matrix3d informationOf(const ReferenceMatch& match, const Eigen::Matrix3d& guess)
{
  return informationBeyond(match.result.guessGivenUp ? MatchResult::unknownCovariance() : guess,
                           match.T_ref_cur.covariance);
}
}  // namespace

Eigen::Matrix3d vagueCovariance()
{
  /** Standard deviations of a guess that is a start and no measurement. Definition: a
   * start that is at most so far off moves a result by less than the result's own standard
   * deviation. */
  constexpr double kSigma_m = 0.5, kSigma_rad = degToRad(10);
  return Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigma_rad * kSigma_rad)
      .asDiagonal();
}

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
  match.T_ref_cur =
      conjugated({match.result.T_ref_cur, match.result.covariance}, mountingRef, mountingCur);
  match.information = informationOf(match, T_ref_cur.covariance);
  match.time_s = preparation_s + stopwatch.lap_s();
  return match;
}

ReferenceMatch PosedScanMatcher::matchViews(std::size_t reference, const Scan& viewRef,
                                            const Scan& viewCur, const UncertainPose& T_ref_cur)
{
  Stopwatch stopwatch;
  const auto preparedRef = matcher_->prepare(viewRef, prepared_.scanner());
  const auto preparedCur = matcher_->prepare(viewCur, prepared_.scanner());
  ReferenceMatch match;
  match.reference = reference;
  match.result = matcher_->matchPrepared(*preparedRef, *preparedCur,
                                         Guess{T_ref_cur.pose, T_ref_cur.covariance},
                                         SearchScope::WithinCovariance);
  match.T_ref_cur = {match.result.T_ref_cur, match.result.covariance};
  match.information = informationOf(match, T_ref_cur.covariance);
  match.time_s = stopwatch.lap_s();
  return match;
}
}  // namespace psmks
