/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/Overlap.h>
#include <psmks/slam/PlaceSearch.h>

#include <Eigen/LU>
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
    if (!policy_.isWithinReach(T_keyframe_cur)) continue;
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
    if (policy_.isWithinReach(T_keyframe_cur) && sawEnough(reference, current))
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

std::vector<KeyframeMap::ExpectedKeyframe> KeyframeMap::loopCandidates(
    const std::vector<PosedScan>& scans, const PosedScan& current, std::size_t reference) const
{
  const auto startNode = nodeOf(reference);
  if (!startNode) return {};
  std::vector<std::pair<double, ExpectedKeyframe>> found;  // each with the overlap there
  for (const LoopCandidate& candidate : withinDrift(scans, current, *startNode))
  {
    const SharedPlace place = findSharedPlace(scans[candidate.keyframe], current,
                                              candidate.expected_T_keyframe_cur, candidate.drift);
    if (policy_.overlapsEnough(place.overlap))
      found.push_back({place.overlap, {candidate.keyframe, place.T_ref_cur}});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<ExpectedKeyframe> expected;
  expected.reserve(found.size());
  for (const auto& [overlap, keyframe] : found) expected.push_back(keyframe);
  return expected;
}

/** The loop candidates that are expected nearest, and as many as a scan has time for: each is
 * searched, which takes about as long as a match. */
std::vector<KeyframeMap::LoopCandidate> KeyframeMap::withinDrift(
    const std::vector<PosedScan>& scans, const PosedScan& current, std::size_t startNode) const
{
  /** Most loop candidates that are searched for one scan; a search takes about as long as a match.
   * Unit: keyframes. Evidence: measured. */
  constexpr std::size_t kMostSearched = 8;
  const std::vector<double> distances_m = graph_.distances_m(startNode);
  std::vector<LoopCandidate> candidates;
  for (const Keyframe& keyframe : keyframes_)
  {
    const Pose2 expected = robotSeenFrom(scans[keyframe.scan], current);
    const Drift drift = policy_.driftAfter(distances_m[keyframe.node]);
    if (policy_.isLoopCandidate(expected, drift))
      candidates.push_back({keyframe.scan, expected, drift});
  }
  const auto isNearer = [](const LoopCandidate& a, const LoopCandidate& b)
  {
    return a.expected_T_keyframe_cur.translation().norm() <
           b.expected_T_keyframe_cur.translation().norm();
  };
  const std::size_t searched = std::min(kMostSearched, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(searched),
                    candidates.end(), isNearer);
  candidates.resize(searched);
  return candidates;
}

bool KeyframeMap::covers(const std::vector<PosedScan>& scans, const PosedScan& current) const
{
  const auto coversIt = [&](const Keyframe& keyframe)
  {
    const PosedScan& reference = scans[keyframe.scan];
    return policy_.isCovered(robotSeenFrom(reference, current)) && sawEnough(reference, current);
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
  const PoseLink added{from, to, link.T_ref_cur.pose,
                       policy_.linkCovariance(link.T_ref_cur.covariance).inverse()};
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
