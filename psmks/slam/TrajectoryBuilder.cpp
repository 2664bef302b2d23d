/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/Preprocessing.h>
#include <psmks/slam/ConsistentLinks.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <Eigen/LU>
#include <utility>

namespace psmks
{
namespace
{
/** T_b_c of T_a_b and T_a_c, where both are matches against the same reference. They share the
 * errors of the reference, which drop out of the difference: the uncertainty that remains is about
 * that of one match. */
UncertainPose motionBetweenMatches(const Pose2& T_a_b, const UncertainPose& T_a_c)
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
    : policy_(reference),
      odometryOptions_(odometry),
      matcher_(std::move(matcher)),
      steadyMotion_(odometry)
{
}

const PosedScan& TrajectoryBuilder::add(Scan scan, const Pose2& T_robot_sensor,
                                        const std::optional<Pose2>& odometry)
{
  const bool isFirst = scans_.empty();
  const UncertainPose predicted = motionBy(odometry, scan.stamp_s);
  const UncertainPose motion = isFirst ? UncertainPose() : predicted;
  deskewer_.deskew(scan, T_robot_sensor, motion);
  append(std::move(scan), T_robot_sensor, odometry, motion);
  if (isFirst)
  {
    makeReference(0);
    return current();
  }
  if (policy_.usesMap())
  {
    map_.standAt(evidence_.keyframe, evidence_.T_keyframe_last);
    chooseKeyframe();
  }
  const UncertainPose T_ref_predicted = composed(T_ref_last_, motion);
  const bool needsMatch = policy_.needsMatch(T_ref_predicted.pose);
  place(needsMatch ? matched(motion, T_ref_predicted) : T_ref_predicted);
  if (becomesReference()) makeReference(currentIndex());
  return current();
}

/** The measured motion, or the last one going on, with its covariance. */
UncertainPose TrajectoryBuilder::motionBy(const std::optional<Pose2>& odometry, double stamp_s)
{
  isMotionMeasured_ = odometry.has_value();
  UncertainPose steady = steadyMotion_.untilScan(stamp_s);
  if (!odometry) return steady;
  return {*odometry, odometryCovariance(*odometry, odometryOptions_)};
}

/** The motion to the current scan tells the speed, and how good the prediction was, if matches tell
 * where both of its ends are. The speed is learnt unless the scans contradict what was expected of
 * it: one match that is wrong would mislead the next. */
void TrajectoryBuilder::learnMotion(const UncertainPose& predicted)
{
  const bool isPreviousKnown = previous().isMatched() || currentIndex() == 1;
  if (!isPreviousKnown) return;
  const Pose2& measured = current().T_last_robot.pose;
  if (isMotionMeasured_) odometryQuality_.learn(predicted, measured);
  const MatchResult& result = current().decidingMatch()->result;
  if (!result.guessGivenUp && !result.contradictsGuess()) steadyMotion_.learn(measured);
}

/** Adds the scan as the current one, where the motion alone puts it. */
void TrajectoryBuilder::append(Scan scan, const Pose2& T_robot_sensor,
                               const std::optional<Pose2>& odometry, const UncertainPose& motion)
{
  PosedScan posed;
  posed.scan = std::move(scan);
  posed.T_robot_sensor = T_robot_sensor;
  posed.T_last_robot = motion;
  if (!scans_.empty())
  {
    posed.T_world_odometry = current().T_world_odometry * odometry.value_or(Pose2());
    posed.T_world_robot = composed(current().T_world_robot, motion);
  }
  scans_.push_back(std::move(posed));
}

/** Makes the keyframe that is nearest to the current scan the reference.
 *
 * The ways on which the map places this keyframe and the last scan may share errors, which cancel
 * in the difference of both. They are taken as independent, so that the covariance of the
 * prediction is too wide where they do. */
void TrajectoryBuilder::chooseKeyframe()
{
  const auto keyframe = map_.nearest(scans_, current());
  if (!keyframe || *keyframe == reference_) return;
  reference_ = *keyframe;
  T_ref_last_ = seenFrom(scans_[reference_].T_world_robot, previous().T_world_robot);
}

/** Matches the current scan against the reference, and once more in other ways where the match
 * fails or explains little of the scan.
 *  @return the robot, seen from the reference that stands in the end */
UncertainPose TrajectoryBuilder::matched(const UncertainPose& motion,
                                         const UncertainPose& T_ref_predicted)
{
  current().decideBy(matcher_.match(scans_, reference_, currentIndex(), T_ref_predicted));
  const bool isBlind = !current().isMatched() && !hasReturns(current().scan);
  if (!isBlind && policy_.needsRetry(current().decidingMatch()->result))
  {
    retryWithPrevious(motion);
    if (!current().isMatched()) retryWithWidePrior(motion);
  }

  const UncertainPose& T_ref_cur = current().decidingMatch()->T_ref_cur;
  if (current().isMatched())
    failuresInARow_ = 0;
  else if (!isBlind)
    ++failuresInARow_;
  if (current().isMatched())
  {
    current().T_last_robot = motionBetweenMatches(T_ref_last_.pose, T_ref_cur);
    learnMotion(motion);
  }
  return T_ref_cur;
}

/** Matches the current scan against the scan before, which shares more with it than the reference
 * does. That scan becomes the reference, unless the match against the reference is usable and this
 * one is not clearly better. */
void TrajectoryBuilder::retryWithPrevious(const UncertainPose& motion)
{
  if (previous().isReference || !previous().isMatched()) return;
  const std::size_t last = currentIndex() - 1;
  ReferenceMatch retry = matcher_.match(scans_, last, currentIndex(), motion);
  const MatchResult& toReference = current().decidingMatch()->result;
  if (toReference.usable() && !policy_.isBetter(retry.result, toReference))
  {
    current().matches.push_back(std::move(retry));
    return;
  }
  current().decideBy(std::move(retry));
  makeReference(last);
}

/** Matches the current scan once more from the odometry, with the covariance of a motion that
 * nobody measured added to that of the odometry: the wheels may have slipped, or their encoders may
 * have missed that they turned backwards. */
void TrajectoryBuilder::retryWithWidePrior(const UncertainPose& motion)
{
  const UncertainPose doubted{motion.pose,
                              motion.covariance + unknownMotionCovariance(odometryOptions_)};
  current().decideBy(
      matcher_.match(scans_, reference_, currentIndex(), composed(T_ref_last_, doubted)));
}

/** Puts the current scan where it is seen from the reference. */
void TrajectoryBuilder::place(const UncertainPose& T_ref_cur)
{
  if (current().isMatched())
    evidence_ = {reference_, T_ref_cur};
  else
    followPrediction();
  current().T_world_robot = composed(scans_[reference_].T_world_robot, T_ref_cur);
  current().anchor = reference_;
  current().T_anchor_robot = T_ref_cur.pose;
  T_ref_last_ = T_ref_cur;
}

/** Without a match, what is known of the last scan and the motion since are all the evidence. */
void TrajectoryBuilder::followPrediction()
{
  UncertainPose motion = current().T_last_robot;
  if (isMotionMeasured_) motion.covariance *= odometryQuality_.varianceFactor();
  evidence_.T_keyframe_last = composed(evidence_.T_keyframe_last, motion);
}

bool TrajectoryBuilder::becomesReference()
{
  const ReferenceMatch* match = current().decidingMatch();
  if (!match) return false;
  if (policy_.usesMap() && current().isMatched())
  {
    map_.standAt(evidence_.keyframe, evidence_.T_keyframe_last);
    return !map_.covers(scans_, current());
  }
  return policy_.replacesReference(match->result, T_ref_last_.pose, failuresInARow_);
}

void TrajectoryBuilder::makeReference(std::size_t index)
{
  scans_[index].isReference = true;
  if (policy_.linksReferences()) addToMap(index);
  reference_ = index;
  T_ref_last_ = UncertainPose();
  evidence_ = {index, UncertainPose()};
  failuresInARow_ = 0;
}

/** Adds the last scan to the map as a keyframe. It is linked to the keyframe from which it was
 * placed, and to keyframes around it by matches that agree with each other. */
void TrajectoryBuilder::addToMap(std::size_t index)
{
  PosedScan& keyframe = scans_[index];
  std::vector<ReferenceMatch> links;
  if (index > 0)
  {
    const UncertainPose& T_keyframe_last = evidence_.T_keyframe_last;
    links.push_back(
        {evidence_.keyframe, T_keyframe_last, T_keyframe_last.covariance.inverse(), {}, 0});
    map_.standAt(evidence_.keyframe, T_keyframe_last);
    keyframe.links = consistentLinks(scans_, keyframe, matchesAround(index));
    links.insert(links.end(), keyframe.links.begin(), keyframe.links.end());
  }
  map_.add(scans_, index, links);
}

/** Matches a scan against the keyframes where it is expected to share much with them, and with a
 * map also against places of earlier visits (LoopSearch). The keyframe from which it was placed is
 * linked to it already, and so is left out. So is the reference: where it is another one, the scan
 * after this one hardly matched it.
 *  @return the matches that are good enough for links */
std::vector<ReferenceMatch> TrajectoryBuilder::matchesAround(std::size_t index)
{
  std::vector<ReferenceMatch> found;
  std::size_t tried = 0;
  for (const KeyframeMap::ExpectedKeyframe& expected : map_.around(scans_, scans_[index]))
  {
    if (expected.keyframe == reference_ || expected.keyframe == evidence_.keyframe) continue;
    if (tried++ == policy_.maxLinks()) break;
    ReferenceMatch candidate =
        matcher_.match(scans_, expected.keyframe, index,
                       {expected.T_keyframe_cur, vagueCovariance()}, SearchScope::NearGuess);
    if (policy_.isLink(candidate.result)) found.push_back(std::move(candidate));
  }
  if (!policy_.usesMap()) return found;
  for (ReferenceMatch& link : loopSearch_.links(scans_, index, evidence_.keyframe,
                                                evidence_.T_keyframe_last, map_, matcher_))
    found.push_back(std::move(link));
  return found;
}

void TrajectoryBuilder::optimise()
{
  if (policy_.linksReferences()) map_.optimise(scans_);
  for (std::size_t s = 0; s < scans_.size(); ++s)
  {
    PosedScan& scan = scans_[s];
    if (scan.isReference || scan.anchor == s) continue;
    scan.T_world_robot.pose = scans_[scan.anchor].T_world_robot.pose * scan.T_anchor_robot;
  }
}
}  // namespace psmks
