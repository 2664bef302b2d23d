/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
Pose2 robotSeenFrom(const PosedScan& keyframe, const PosedScan& current)
{
  return keyframe.T_world_robot.pose.inverse() * current.T_world_robot.pose;
}
}  // namespace

std::optional<std::size_t> KeyframeMap::nearest(const std::vector<PosedScan>& scans,
                                                const PosedScan& current) const
{
  std::optional<std::size_t> best;
  double bestDistance = 0;
  for (const Keyframe& keyframe : keyframes_)
  {
    const PosedScan& reference = scans[keyframe.scan];
    const Pose2 T_keyframe_cur = robotSeenFrom(reference, current);
    if (!policy_.isWithinReach(T_keyframe_cur) || !isKnown(keyframe)) continue;
    const double distance = policy_.normalizedDistance(T_keyframe_cur);
    if (best && distance >= bestDistance) continue;
    if (!sawEnough(reference, current)) continue;
    best = keyframe.scan;
    bestDistance = distance;
  }
  return best;
}

std::vector<KeyframeMap::ExpectedKeyframe> KeyframeMap::around(const std::vector<PosedScan>& scans,
                                                               const PosedScan& current) const
{
  std::vector<ExpectedKeyframe> expected;
  for (std::size_t k = policy_.firstLinkable(keyframes_.size()); k < keyframes_.size(); ++k)
  {
    const PosedScan& reference = scans[keyframes_[k].scan];
    const Pose2 T_keyframe_cur = robotSeenFrom(reference, current);
    if (policy_.isWithinReach(T_keyframe_cur) && isKnown(keyframes_[k]) &&
        sawEnough(reference, current))
      expected.push_back({keyframes_[k].scan, T_keyframe_cur});
  }
  const auto isNearer = [this](const ExpectedKeyframe& a, const ExpectedKeyframe& b)
  {
    return policy_.normalizedDistance(a.T_keyframe_cur) <
           policy_.normalizedDistance(b.T_keyframe_cur);
  };
  std::sort(expected.begin(), expected.end(), isNearer);
  return expected;
}

void KeyframeMap::standAt(std::size_t keyframe, const UncertainPose& T_keyframe_cur)
{
  const auto node = nodeOf(keyframe);
  if (!node) return;
  T_standing_cur_ = T_keyframe_cur;
  const bool isUpToDate =
      !covariances_.empty() && *node == standingAt_ && linksThen_ == graph_.links().size();
  if (isUpToDate) return;
  standingAt_ = *node;
  linksThen_ = graph_.links().size();
  covariances_.assign(keyframes_.size(), std::nullopt);
  for (const PoseGraph::KnownNode& known : graph_.known(*node))
    covariances_[known.node] = known.covariance;
}

/** Where the graph expects the current scan, seen from a keyframe; none where no links lead there.
 */
std::optional<UncertainPose> KeyframeMap::expectedFrom(const Keyframe& keyframe) const
{
  if (keyframe.node >= covariances_.size() || !covariances_[keyframe.node]) return std::nullopt;
  const UncertainPose T_standing_keyframe{
      graph_.poses()[standingAt_].inverse() * graph_.poses()[keyframe.node],
      *covariances_[keyframe.node]};
  return seenFrom(T_standing_keyframe, T_standing_cur_);
}

bool KeyframeMap::isKnown(const Keyframe& keyframe) const
{
  const auto expected = expectedFrom(keyframe);
  return expected && policy_.isKnown(expected->covariance);
}

std::vector<KeyframeMap::UncertainKeyframe> KeyframeMap::possiblePlaces() const
{
  std::vector<UncertainKeyframe> places;
  for (const Keyframe& keyframe : keyframes_)
  {
    const auto expected = expectedFrom(keyframe);
    if (!expected || policy_.isKnown(expected->covariance)) continue;
    if (expected->pose.translation().norm() < policy_.loopReach_m(expected->covariance))
      places.push_back({keyframe.scan, *expected});
  }
  return places;
}

std::vector<std::size_t> KeyframeMap::localMap(std::size_t keyframe, double mostOpen_m) const
{
  /** Most keyframes of a local map. Unit: keyframes. Evidence: with 30 and 60 the maps of csail,
   * Freiburg campus and Acapulco are the same, and a search takes longer. */
  constexpr std::size_t kMost = 15;
  const auto centre = nodeOf(keyframe);
  if (!centre || !(mostOpen_m > 0)) return {};
  std::vector<std::pair<double, std::size_t>> near;  // each with its distance
  for (const PoseGraph::KnownNode& known : graph_.known(*centre, mostOpen_m))
  {
    const double apart_m =
        (graph_.poses()[known.node].translation() - graph_.poses()[*centre].translation()).norm();
    near.emplace_back(apart_m, keyframes_[known.node].scan);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > kMost) near.resize(kMost);
  std::vector<std::size_t> members;
  members.reserve(near.size());
  for (const auto& [apart_m, scan] : near) members.push_back(scan);
  return members;
}

bool KeyframeMap::covers(const std::vector<PosedScan>& scans, const PosedScan& current) const
{
  const auto coversIt = [&](const Keyframe& keyframe)
  {
    const PosedScan& reference = scans[keyframe.scan];
    return policy_.isCovered(robotSeenFrom(reference, current)) && isKnown(keyframe) &&
           sawEnough(reference, current);
  };
  return std::any_of(keyframes_.begin(), keyframes_.end(), coversIt);
}

bool KeyframeMap::sawEnough(const PosedScan& keyframe, const PosedScan& current) const
{
  const Pose2 T_ref_cur = keyframe.T_world_sensor().inverse() * current.T_world_sensor();
  return policy_.overlapsEnough(overlap(keyframe.scan, current.scan, T_ref_cur));
}

/** The node of a scan in the graph; none where the scan is no keyframe. */
std::optional<std::size_t> KeyframeMap::nodeOf(std::size_t scan) const
{
  for (const Keyframe& keyframe : keyframes_)
    if (keyframe.scan == scan) return keyframe.node;
  return std::nullopt;
}

void KeyframeMap::add(std::vector<PosedScan>& scans, std::size_t index,
                      const std::vector<ReferenceMatch>& links)
{
  /** Links that contradict the poses by less wait for the next optimisation, or for the end of the
   * log. Evidence: measured. */
  constexpr double kSmallContradiction_m = 0.01;

  /** Links that contradict the poses by more move all keyframes, else only the recent ones move.
   * Evidence: measured. */
  constexpr double kGrossContradiction_m = 0.05;

  /** How many of the last keyframes a small contradiction moves. Unit: keyframes. Evidence:
   * measured. */
  constexpr std::size_t kRecentNodes = 30;
  const std::size_t node = graph_.add(scans[index].T_world_robot.pose);
  keyframes_.push_back({index, node});
  double contradiction_m = 0;
  for (const ReferenceMatch& link : links)
    if (const auto from = nodeOf(link.reference))
      contradiction_m = std::max(contradiction_m, addLink(link, *from, node));
  if (contradiction_m > kGrossContradiction_m)
    optimise(scans, 0);
  else if (contradiction_m > kSmallContradiction_m)
    optimise(scans, node > kRecentNodes ? node - kRecentNodes : 0);
}

/** @return by how far the link contradicts the poses of its nodes, a heading by what it moves at
 * the end of a lever */
double KeyframeMap::addLink(const ReferenceMatch& link, std::size_t from, std::size_t to)
{
  /** Distance at which an error of a heading counts as a displacement. Evidence: measured. */
  constexpr double kLever_m = 2;
  const PoseLink added{from, to, link.T_ref_cur.pose, policy_.linkInformation(link.information)};
  graph_.add(added);
  const Eigen::Vector3d error = linkError(added, graph_.poses()[from], graph_.poses()[to]);
  return error.head<2>().norm() + kLever_m * std::abs(error.z());
}

void KeyframeMap::optimise(std::vector<PosedScan>& scans) { optimise(scans, 0); }

void KeyframeMap::optimise(std::vector<PosedScan>& scans, std::size_t firstFree)
{
  graph_.optimise(firstFree);
  for (const Keyframe& keyframe : keyframes_)
    scans[keyframe.scan].T_world_robot.pose = graph_.poses()[keyframe.node];
}
}  // namespace psmks
