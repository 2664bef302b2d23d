/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** T_b_c of T_a_b and T_a_c. Matches against the same reference share its errors, which drop out of
 *  their difference: about one match's worth of uncertainty remains. */
UncertainPose difference(const Pose2& T_a_b, const UncertainPose& T_a_c)
{
  const Pose2 T_b_a = T_a_b.inverse();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = T_b_a.rotation();
  return {T_b_a * T_a_c.pose, R * T_a_c.covariance * R.transpose()};
}
/** Of a guess that is a start and no measurement: so wide that it moves no result by 0.01 mm. */
Eigen::Matrix3d vagueCovariance()
{
  constexpr double kSigma_m = 0.5, kSigma_rad = degToRad(10);
  return Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigma_rad * kSigma_rad)
      .asDiagonal();
}
/** Whether two corrections of a pose say the same. */
bool isAlike(const Pose2& a, const Pose2& b)
{
  constexpr double kApart_m = 0.05, kApart_rad = degToRad(1);
  return (a.translation() - b.translation()).norm() < kApart_m &&
         std::abs(wrapAngle(a.phi_rad - b.phi_rad)) < kApart_rad;
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
  straighten(current, odometry);
  if (!isFirst) place(current, odometry);
  scans_.push_back(std::move(current));

  if (isFirst || isNewReference()) makeReference(scans_.size() - 1);
  return scans_.back();
}

/** The motion that led to a scan tells how the robot turned while it swept. */
void TrajectoryBuilder::straighten(PosedScan& current, const std::optional<Pose2>& odometry)
{
  const double turned_rad = scans_.empty() ? 0 : measuredMotion(odometry).pose.phi_rad;
  turnRate_.add(current.stamp_s(), turned_rad);
  straightenSweep(current.scan, turnRate_.rate_rad_s());
}

bool TrajectoryBuilder::isNewReference() const
{
  const PosedScan& current = scans_.back();
  if (current.matches.empty()) return false;
  if (policy_.usesMap() && current.isMatched()) return !map_.covers(scans_, current);
  return policy_.isReplaced(current.matches.back().result, T_ref_last_.pose, failuresInARow_);
}

void TrajectoryBuilder::optimise()
{
  if (policy_.tiesReferences()) map_.optimise(scans_);
  for (std::size_t s = 0; s < scans_.size(); ++s)
  {
    PosedScan& scan = scans_[s];
    if (scan.isReference || scan.anchor == s) continue;
    scan.T_world_robot.pose = scans_[scan.anchor].T_world_robot.pose * scan.T_anchor_robot;
  }
}

void TrajectoryBuilder::place(PosedScan& current, const std::optional<Pose2>& odometry)
{
  const UncertainPose motion = measuredMotion(odometry);
  current.T_last_robot = motion;
  current.T_world_odometry = scans_.back().T_world_odometry * odometry.value_or(Pose2());

  if (policy_.usesMap())
  {
    current.T_world_robot = composed(scans_.back().T_world_robot, motion);
    const auto keyframe = map_.nearest(scans_, current);
    if (keyframe && *keyframe != reference_) returnTo(*keyframe);
  }
  UncertainPose T_ref_cur = composed(T_ref_last_, motion);
  if (policy_.isMatched(T_ref_cur.pose)) T_ref_cur = matched(current, motion, T_ref_cur);
  current.T_world_robot = composed(scans_[reference_].T_world_robot, T_ref_cur);
  current.anchor = reference_;
  current.T_anchor_robot = T_ref_cur.pose;
  T_ref_last_ = T_ref_cur;
}

/** Against the reference; where that fails or explains little, against the last scan, which shares
 * more with this one; where that fails too, without faith in the odometry.
 *  @return the robot seen from the reference that stands in the end */
UncertainPose TrajectoryBuilder::matched(PosedScan& current, const UncertainPose& motion,
                                         const UncertainPose& guess)
{
  current.matches.push_back(match(current, reference_, guess));
  if (policy_.isRetried(current.matches.back().result)) retry(current, motion);

  const ReferenceMatch& best = current.matches.back();
  failuresInARow_ = current.isMatched() ? 0 : failuresInARow_ + 1;
  if (current.isMatched()) current.T_last_robot = difference(T_ref_last_.pose, best.T_ref_cur);
  return best.T_ref_cur;
}

void TrajectoryBuilder::retry(PosedScan& current, const UncertainPose& motion)
{
  matchToLast(current, motion);
  if (!current.isMatched()) matchWithInflatedPrior(current, motion);
}

void TrajectoryBuilder::matchToLast(PosedScan& current, const UncertainPose& motion)
{
  const PosedScan& last = scans_.back();
  if (last.isReference || !last.isMatched()) return;
  matcher_->setReference(last.scan);
  const ReferenceMatch second = match(current, scans_.size() - 1, motion);
  ReferenceMatch& first = current.matches.back();
  if (first.result.usable() && !policy_.isBetter(second.result, first.result))
  {
    matcher_->setReference(scans_[reference_].scan);
    current.matches.insert(current.matches.end() - 1, second);
    return;
  }
  current.matches.push_back(second);
  makeReference(scans_.size() - 1);
}

/** The wheels may have slipped, or turned backwards unnoticed. */
void TrajectoryBuilder::matchWithInflatedPrior(PosedScan& current, const UncertainPose& motion)
{
  const UncertainPose doubted{motion.pose,
                              motion.covariance + unknownMotionCovariance(odometryOptions_)};
  current.matches.push_back(match(current, reference_, composed(T_ref_last_, doubted)));
}

UncertainPose TrajectoryBuilder::measuredMotion(const std::optional<Pose2>& odometry) const
{
  if (odometry) return {*odometry, odometryCovariance(*odometry, odometryOptions_)};
  return {scans_.back().T_last_robot.pose, unknownMotionCovariance(odometryOptions_)};
}

ReferenceMatch TrajectoryBuilder::match(const PosedScan& current, std::size_t reference,
                                        const UncertainPose& T_ref_cur, SearchScope scope)
{
  const Pose2& mountingRef = scans_[reference].T_robot_sensor;
  const Pose2& mountingCur = current.T_robot_sensor;
  const UncertainPose guess = conjugated(T_ref_cur, mountingRef.inverse(), mountingCur.inverse());

  ReferenceMatch match;
  match.reference = reference;
  Stopwatch stopwatch;
  match.result =
      matcher_->matchToReference(current.scan, Guess{guess.pose, guess.covariance}, scope);
  match.time_s = stopwatch.lap_s();
  match.T_ref_cur =
      conjugated({match.result.T_ref_cur, match.result.covariance}, mountingRef, mountingCur);
  return match;
}

void TrajectoryBuilder::makeReference(std::size_t index)
{
  scans_[index].isReference = true;
  if (policy_.tiesReferences()) joinMap(index);
  matcher_->setReference(scans_[index].scan);
  reference_ = index;
  T_ref_last_ = UncertainPose();
  failuresInARow_ = 0;
}

/** A keyframe of the map hangs on the match that made it, or on odometry, and on matches against
 * the keyframes around it. */
void TrajectoryBuilder::joinMap(std::size_t index)
{
  PosedScan& keyframe = scans_[index];
  std::vector<ReferenceMatch> links;
  if (index > 0)
  {
    links.push_back({reference_, T_ref_last_, {}, 0});
    keyframe.links = consistentLinks(keyframe, matchesAround(keyframe));
    links.insert(links.end(), keyframe.links.begin(), keyframe.links.end());
  }
  map_.add(scans_, index, links);
}

std::vector<ReferenceMatch> TrajectoryBuilder::matchesAround(const PosedScan& current)
{
  std::vector<ReferenceMatch> found;
  const auto tie = [&](const std::vector<KeyframeMap::View>& views, std::size_t most)
  {
    std::size_t tried = 0;
    for (const KeyframeMap::View& view : views)
    {
      if (view.keyframe == reference_) continue;
      if (tried++ == most) break;
      matcher_->setReference(scans_[view.keyframe].scan);
      const ReferenceMatch candidate = match(
          current, view.keyframe, {view.T_keyframe_cur, vagueCovariance()}, SearchScope::NearGuess);
      if (policy_.isLink(candidate.result)) found.push_back(candidate);
    }
  };
  tie(map_.around(scans_, current), policy_.maxLinks());
  if (policy_.usesMap()) tie(map_.loopCandidates(scans_, current, reference_), policy_.maxLinks());
  return found;
}

/** A match counts where it agrees with the map, or with another match: a loop that closes moves the
 * scan against all old keyframes alike, a wrong match is alone. */
std::vector<ReferenceMatch> TrajectoryBuilder::consistentLinks(
    const PosedScan& current, const std::vector<ReferenceMatch>& found) const
{
  std::vector<Pose2> corrections;  // of the scan's pose, by each match
  for (const ReferenceMatch& match : found)
  {
    const Pose2 expected =
        scans_[match.reference].T_world_robot.pose.inverse() * current.T_world_robot.pose;
    corrections.push_back(expected.inverse() * match.T_ref_cur.pose);
  }
  std::vector<ReferenceMatch> consistent;
  for (std::size_t m = 0; m < found.size(); ++m)
  {
    const auto agrees = [&](const Pose2& other) { return isAlike(corrections[m], other); };
    const auto witnesses = std::count_if(corrections.begin(), corrections.end(), agrees);
    if (agrees(Pose2()) || witnesses > 1) consistent.push_back(found[m]);
  }
  return consistent;
}

/** The way here and the way there may share errors; taken as independent they make the guess less
 * certain than it is, which does no harm. */
void TrajectoryBuilder::returnTo(std::size_t keyframe)
{
  const PosedScan& reference = scans_[keyframe];
  matcher_->setReference(reference.scan);
  reference_ = keyframe;
  T_ref_last_ = seenFrom(reference.T_world_robot, scans_.back().T_world_robot);
}
}  // namespace psmks
