/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Overlap.h>
#include <psmks/mrpt/KeyframeMap.h>

#include <Eigen/LU>
#include <algorithm>

namespace psmks
{
namespace
{
Pose2 seenFrom(const PosedScan& keyframe, const PosedScan& current)
{
  return keyframe.T_world_robot.pose.inverse() * current.T_world_robot.pose;
}
}  // namespace

std::vector<std::size_t> KeyframeMap::around(const std::vector<PosedScan>& scans,
                                             const PosedScan& current) const
{
  std::vector<std::pair<double, std::size_t>> candidates;
  for (const Keyframe& keyframe : keyframes_)
  {
    const PosedScan& reference = scans[keyframe.scan];
    const Pose2 T_keyframe_cur = seenFrom(reference, current);
    if (policy_.isCandidate(T_keyframe_cur) && isSeen(reference, current))
      candidates.emplace_back(policy_.remoteness(T_keyframe_cur), keyframe.scan);
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<std::size_t> sorted;
  for (const auto& [remoteness, scan] : candidates) sorted.push_back(scan);
  return sorted;
}

std::optional<std::size_t> KeyframeMap::nearest(const std::vector<PosedScan>& scans,
                                                const PosedScan& current) const
{
  std::optional<std::size_t> best;
  double bestRemoteness = 0;
  for (const Keyframe& keyframe : keyframes_)
  {
    const PosedScan& reference = scans[keyframe.scan];
    const Pose2 T_keyframe_cur = seenFrom(reference, current);
    if (!policy_.isCandidate(T_keyframe_cur)) continue;
    const double remoteness = policy_.remoteness(T_keyframe_cur);
    if (best && remoteness >= bestRemoteness) continue;
    if (!isSeen(reference, current)) continue;
    best = keyframe.scan;
    bestRemoteness = remoteness;
  }
  return best;
}

bool KeyframeMap::covers(const std::vector<PosedScan>& scans, const PosedScan& current) const
{
  const auto coversIt = [&](const Keyframe& keyframe)
  {
    const PosedScan& reference = scans[keyframe.scan];
    return policy_.isCovered(seenFrom(reference, current)) && isSeen(reference, current);
  };
  return std::any_of(keyframes_.begin(), keyframes_.end(), coversIt);
}

bool KeyframeMap::isSeen(const PosedScan& keyframe, const PosedScan& current) const
{
  const Pose2 T_ref_cur = keyframe.T_world_sensor().inverse() * current.T_world_sensor();
  return policy_.isEnough(overlap(keyframe.scan, current.scan, T_ref_cur));
}

std::optional<std::size_t> KeyframeMap::nodeOf(std::size_t scan) const
{
  for (const Keyframe& keyframe : keyframes_)
    if (keyframe.scan == scan) return keyframe.node;
  return std::nullopt;
}

void KeyframeMap::add(std::vector<PosedScan>& scans, std::size_t index,
                      const std::vector<ReferenceMatch>& links)
{
  const std::size_t node = graph_.add(scans[index].T_world_robot.pose);
  for (const ReferenceMatch& link : links)
    if (const auto from = nodeOf(link.reference))
      graph_.add({*from, node, link.T_ref_cur.pose, link.T_ref_cur.covariance.inverse()});
  keyframes_.push_back({index, node});
  graph_.optimise();
  for (const Keyframe& keyframe : keyframes_)
    scans[keyframe.scan].T_world_robot.pose = graph_.poses()[keyframe.node];
}
}  // namespace psmks
