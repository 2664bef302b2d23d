/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** How far two robots are apart and turned, in the axes of the world. */
Pose2 apart(const PosedScan& keyframe, const PosedScan& current)
{
  const Pose2 &a = keyframe.T_world_robot.pose, &b = current.T_world_robot.pose;
  return {b.x_m - a.x_m, b.y_m - a.y_m, wrapAngle(b.phi_rad - a.phi_rad)};
}
}  // namespace

std::optional<std::size_t> KeyframeMap::nearest(const std::vector<PosedScan>& scans,
                                                const PosedScan& current) const
{
  std::optional<std::size_t> best;
  double bestDistance = 0;
  for (const PoseGraph::KnownNode& keyframe : near_)
  {
    const PosedScan& reference = scans[scanOf_[keyframe.node]];
    const Pose2 between = apart(reference, current);
    if (!policy_.isWithinReach(between)) continue;
    const double distance = policy_.normalizedDistance(between);
    if (best && distance >= bestDistance) continue;
    if (!isKnown(keyframe) || !sawEnough(reference, current)) continue;
    best = scanOf_[keyframe.node];
    bestDistance = distance;
  }
  return best;
}

std::vector<KeyframeMap::ExpectedKeyframe> KeyframeMap::around(const std::vector<PosedScan>& scans,
                                                               const PosedScan& current) const
{
  std::vector<ExpectedKeyframe> expected;
  for (const PoseGraph::KnownNode& keyframe : near_)
  {
    const PosedScan& reference = scans[scanOf_[keyframe.node]];
    if (keyframe.node >= policy_.firstLinkable(scanOf_.size()) &&
        policy_.isWithinReach(apart(reference, current)) && isKnown(keyframe) &&
        sawEnough(reference, current))
      expected.push_back({scanOf_[keyframe.node],
                          reference.T_world_robot.pose.inverse() * current.T_world_robot.pose});
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
      !near_.empty() && *node == standingAt_ && linksThen_ == graph_.links().size();
  if (isUpToDate) return;
  standingAt_ = *node;
  linksThen_ = graph_.links().size();
  near_ = graph_.known(*node, policy_.mostOpen_m());
  std::sort(near_.begin(), near_.end(),
            [](const PoseGraph::KnownNode& a, const PoseGraph::KnownNode& b)
            { return a.node < b.node; });
}

/** Where the graph expects the current scan, seen from a keyframe.
 *  @param keyframe as the graph knows it from where the scan is known */
UncertainPose KeyframeMap::expectedFrom(const PoseGraph::KnownNode& keyframe) const
{
  const UncertainPose T_standing_keyframe{
      graph_.poses()[standingAt_].inverse() * graph_.poses()[keyframe.node], keyframe.covariance};
  return seenFrom(T_standing_keyframe, T_standing_cur_);
}

bool KeyframeMap::isKnown(const PoseGraph::KnownNode& keyframe) const
{
  return policy_.isKnown(expectedFrom(keyframe).covariance);
}

std::vector<KeyframeMap::UncertainKeyframe> KeyframeMap::possiblePlaces() const
{
  std::vector<UncertainKeyframe> places;
  if (scanOf_.empty()) return places;
  for (const PoseGraph::KnownNode& keyframe : graph_.known(standingAt_))
  {
    const UncertainPose expected = expectedFrom(keyframe);
    if (!policy_.isKnown(expected.covariance) &&
        expected.pose.translation().norm() < policy_.loopReach_m(expected.covariance))
      places.push_back({scanOf_[keyframe.node], expected});
  }
  std::sort(places.begin(), places.end(),
            [](const UncertainKeyframe& a, const UncertainKeyframe& b)
            { return a.keyframe < b.keyframe; });
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
    near.emplace_back(apart_m, scanOf_[known.node]);
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
  const auto coversIt = [&](const PoseGraph::KnownNode& keyframe)
  {
    const PosedScan& reference = scans[scanOf_[keyframe.node]];
    return policy_.isCovered(apart(reference, current)) && isKnown(keyframe) &&
           sawEnough(reference, current);
  };
  return std::any_of(near_.begin(), near_.end(), coversIt);
}

bool KeyframeMap::sawEnough(const PosedScan& keyframe, const PosedScan& current) const
{
  const Pose2 T_ref_cur = keyframe.T_world_sensor().inverse() * current.T_world_sensor();
  return policy_.overlapsEnough(overlap(keyframe.scan, current.scan, T_ref_cur));
}

/** The node of a scan in the graph; none where the scan is no keyframe. */
std::optional<std::size_t> KeyframeMap::nodeOf(std::size_t scan) const
{
  const auto found = std::lower_bound(scanOf_.begin(), scanOf_.end(), scan);
  if (found == scanOf_.end() || *found != scan) return std::nullopt;
  return static_cast<std::size_t>(found - scanOf_.begin());
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
  scanOf_.push_back(index);
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
  for (std::size_t node = firstFree; node < scanOf_.size(); ++node)
    scans[scanOf_[node]].T_world_robot.pose = graph_.poses()[node];
}
}  // namespace psmks
