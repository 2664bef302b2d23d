/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Overlap.h>
#include <psmks/core/Stopwatch.h>
#include <psmks/mrpt/TrajectoryBuilder.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** T_a_c of T_a_b and T_b_c with independent errors. */
UncertainPose composed(const UncertainPose& T_a_b, const UncertainPose& T_b_c)
{
  return toUncertainPose(toMrpt(T_a_b) + toMrpt(T_b_c));
}
/** T_b_c of T_a_b and T_a_c. Matches against the same reference share its errors, which drop out of
 *  their difference: about one match's worth of uncertainty remains. */
UncertainPose difference(const Pose2& T_a_b, const UncertainPose& T_a_c)
{
  const Pose2 T_b_a = T_a_b.inverse();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = T_b_a.rotation();
  return {T_b_a * T_a_c.pose, R * T_a_c.covariance * R.transpose()};
}
}  // namespace

TrajectoryBuilder::TrajectoryBuilder(std::unique_ptr<PairMatcher> matcher,
                                     const ReferenceOptions& reference,
                                     const OdometryOptions& odometry)
    : matcher_(std::move(matcher)), policy_(reference), odometryOptions_(odometry)
{
}

const PosedScan& TrajectoryBuilder::add(Scan scan, const Pose2& T_robot_sensor,
                                        const std::optional<Pose2>& odometry)
{
  PosedScan current;
  current.scan = std::move(scan);
  current.T_robot_sensor = T_robot_sensor;
  const bool isFirst = scans_.empty();
  if (!isFirst) place(current, odometry);
  scans_.push_back(std::move(current));

  if (isFirst || isNewReference()) makeReference(scans_.size() - 1);
  return scans_.back();
}

bool TrajectoryBuilder::isNewReference() const
{
  const PosedScan& current = scans_.back();
  if (current.matches.empty()) return false;
  if (policy_.usesMap() && current.isMatched()) return !isCovered(current);
  return policy_.isReplaced(current.matches.back().result, T_ref_last_.pose, failuresInARow_);
}

bool TrajectoryBuilder::isCovered(const PosedScan& current) const
{
  const auto covers = [&](std::size_t keyframe)
  {
    const Pose2 T_keyframe_cur =
        scans_[keyframe].T_world_robot.pose.inverse() * current.T_world_robot.pose;
    return policy_.isCovered(T_keyframe_cur) && isSeenBy(keyframe, current);
  };
  return std::any_of(keyframes_.begin(), keyframes_.end(), covers);
}

bool TrajectoryBuilder::isSeenBy(std::size_t keyframe, const PosedScan& current) const
{
  const PosedScan& reference = scans_[keyframe];
  const Pose2 T_ref_cur = reference.T_world_sensor().inverse() * current.T_world_sensor();
  return policy_.isEnough(overlap(reference.scan, current.scan, T_ref_cur));
}

/** Variance that the pose of a keyframe hands on to a scan matched against it. */
double TrajectoryBuilder::doubt_m2(std::size_t keyframe, const PosedScan& current) const
{
  const UncertainPose& T_world_keyframe = scans_[keyframe].T_world_robot;
  const Eigen::Matrix3d& covariance = T_world_keyframe.covariance;
  const Pose2 T_keyframe_cur = T_world_keyframe.pose.inverse() * current.T_world_robot.pose;
  return covariance(0, 0) + covariance(1, 1) +
         covariance(2, 2) * T_keyframe_cur.translation().squaredNorm();
}

std::optional<std::size_t> TrajectoryBuilder::bestKeyframe(const PosedScan& current) const
{
  std::optional<std::size_t> best;
  double bestDoubt_m2 = 0;
  for (const std::size_t keyframe : keyframes_)
  {
    const Pose2 T_keyframe_cur =
        scans_[keyframe].T_world_robot.pose.inverse() * current.T_world_robot.pose;
    if (!policy_.isCandidate(T_keyframe_cur)) continue;
    const double candidateDoubt_m2 = doubt_m2(keyframe, current);
    if (best && candidateDoubt_m2 >= bestDoubt_m2) continue;
    if (!isSeenBy(keyframe, current)) continue;
    best = keyframe;
    bestDoubt_m2 = candidateDoubt_m2;
  }
  return best;
}

void TrajectoryBuilder::place(PosedScan& current, const std::optional<Pose2>& odometry)
{
  const UncertainPose motion = measuredMotion(odometry);
  current.T_last_robot = motion;
  current.T_world_odometry = scans_.back().T_world_odometry * odometry.value_or(Pose2());

  if (policy_.usesMap())
  {
    current.T_world_robot = composed(scans_.back().T_world_robot, motion);
    const auto keyframe = bestKeyframe(current);
    if (keyframe && *keyframe != reference_) returnTo(*keyframe);
  }
  UncertainPose T_ref_cur = composed(T_ref_last_, motion);
  const bool failed = policy_.isMatched(T_ref_cur.pose) && !tryMatch(current, T_ref_cur);
  if (failed && policy_.isRetried() && scans_.back().isMatched() && !scans_.back().isReference)
  {
    makeReference(scans_.size() - 1);
    T_ref_cur = motion;
    tryMatch(current, T_ref_cur);
  }
  current.T_world_robot = composed(scans_[reference_].T_world_robot, T_ref_cur);
  T_ref_last_ = T_ref_cur;
}

bool TrajectoryBuilder::tryMatch(PosedScan& current, UncertainPose& T_ref_cur)
{
  current.matches.push_back(match(current, T_ref_cur));
  T_ref_cur = current.matches.back().T_ref_cur;
  if (!current.isMatched())
  {
    ++failuresInARow_;
    return false;
  }
  failuresInARow_ = 0;
  current.T_last_robot = difference(T_ref_last_.pose, T_ref_cur);
  return true;
}

UncertainPose TrajectoryBuilder::measuredMotion(const std::optional<Pose2>& odometry) const
{
  if (odometry) return {*odometry, odometryCovariance(*odometry, odometryOptions_)};
  return {scans_.back().T_last_robot.pose, unknownMotionCovariance(odometryOptions_)};
}

ReferenceMatch TrajectoryBuilder::match(const PosedScan& current, const UncertainPose& guess)
{
  const Pose2& mountingRef = scans_[reference_].T_robot_sensor;
  const Pose2& mountingCur = current.T_robot_sensor;
  const UncertainPose sensorGuess = conjugated(guess, mountingRef.inverse(), mountingCur.inverse());

  ReferenceMatch match;
  match.reference = reference_;
  Stopwatch stopwatch;
  match.result =
      matcher_->matchToReference(current.scan, {sensorGuess.pose, sensorGuess.covariance});
  match.time_s = stopwatch.lap_s();
  match.T_ref_cur =
      conjugated({match.result.T_ref_cur, match.result.covariance}, mountingRef, mountingCur);
  return match;
}

void TrajectoryBuilder::makeReference(std::size_t index)
{
  scans_[index].isReference = true;
  keyframes_.push_back(index);
  matcher_->setReference(scans_[index].scan);
  reference_ = index;
  T_ref_last_ = UncertainPose();
  failuresInARow_ = 0;
}

/** The way here and the way there may share errors; taken as independent they make the guess less
 * certain than it is, which does no harm. */
void TrajectoryBuilder::returnTo(std::size_t keyframe)
{
  const PosedScan& reference = scans_[keyframe];
  matcher_->setReference(reference.scan);
  reference_ = keyframe;
  T_ref_last_ =
      toUncertainPose(toMrpt(scans_.back().T_world_robot) - toMrpt(reference.T_world_robot));
}
}  // namespace psmks
