/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/GraphDistance.h>
#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/Overlap.h>
#include <psmks/slam/PlaceSearch.h>

#include <Eigen/LU>
#include <algorithm>

namespace psmks
{
namespace
{
// Links that contradict the poses by less wait for the next time, or for the end; by more, all
// poses are set anew, else only those of the last keyframes.
constexpr double kSmallInnovation_m = 0.01;
constexpr double kGrossInnovation_m = 0.05;
constexpr double kLever_m = 2;  //!< what a heading error moves is this far away
constexpr std::size_t kRecentNodes = 30;

/** What a match may be wrong by besides the noise of its rays: people, glass, things at the height
 * of the scanner that are not upright. */
Eigen::Matrix3d informationOf(const ReferenceMatch& link)
{
  constexpr double kSigma_m = 0.005, kSigma_rad = degToRad(0.1);
  Eigen::Matrix3d covariance = link.T_ref_cur.covariance;
  covariance.diagonal() +=
      Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigma_rad * kSigma_rad);
  return covariance.inverse();
}

/** An old keyframe that may be near, if the way since has drifted. */
struct LoopCandidate
{
  std::size_t keyframe;
  Pose2 expected_T_keyframe_cur;
  Drift drift;

  double normalizedDistance() const { return expected_T_keyframe_cur.translation().norm(); }
};

// So many are looked for at most: a search takes about as long as a match.
constexpr std::size_t kMostSearched = 8;

Pose2 seenFrom(const PosedScan& keyframe, const PosedScan& current)
{
  return keyframe.T_world_robot.pose.inverse() * current.T_world_robot.pose;
}
}  // namespace

std::vector<KeyframeMap::View> KeyframeMap::around(const std::vector<PosedScan>& scans,
                                                   const PosedScan& current) const
{
  std::vector<View> views;
  for (std::size_t k = policy_.firstTied(keyframes_.size()); k < keyframes_.size(); ++k)
  {
    const PosedScan& reference = scans[keyframes_[k].scan];
    const Pose2 T_keyframe_cur = seenFrom(reference, current);
    if (policy_.isCandidate(T_keyframe_cur) && isSeen(reference, current))
      views.push_back({keyframes_[k].scan, T_keyframe_cur});
  }
  const auto isNearer = [this](const View& a, const View& b)
  {
    return policy_.normalizedDistance(a.T_keyframe_cur) <
           policy_.normalizedDistance(b.T_keyframe_cur);
  };
  std::sort(views.begin(), views.end(), isNearer);
  return views;
}

std::vector<KeyframeMap::View> KeyframeMap::loopCandidates(const std::vector<PosedScan>& scans,
                                                           const PosedScan& current,
                                                           std::size_t reference) const
{
  const auto start = nodeOf(reference);
  if (!start) return {};
  const std::vector<double> distances_m = graphDistances_m(graph_, *start);
  std::vector<LoopCandidate> lost;
  for (const Keyframe& keyframe : keyframes_)
  {
    const Pose2 expected = seenFrom(scans[keyframe.scan], current);
    const Drift drift = policy_.driftAfter(distances_m[keyframe.node]);
    if (policy_.isLoopCandidate(expected, drift)) lost.push_back({keyframe.scan, expected, drift});
  }
  const std::size_t searched = std::min(kMostSearched, lost.size());
  std::partial_sort(lost.begin(), lost.begin() + static_cast<std::ptrdiff_t>(searched), lost.end(),
                    [](const LoopCandidate& a, const LoopCandidate& b)
                    { return a.normalizedDistance() < b.normalizedDistance(); });
  lost.resize(searched);

  std::vector<std::pair<double, View>> found;
  for (const LoopCandidate& old : lost)
  {
    const SharedPlace place =
        findSharedPlace(scans[old.keyframe], current, old.expected_T_keyframe_cur, old.drift);
    if (policy_.isEnough(place.overlap))
      found.push_back({place.overlap, {old.keyframe, place.T_ref_cur}});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<View> views;
  for (const auto& [share, view] : found) views.push_back(view);
  return views;
}

std::optional<std::size_t> KeyframeMap::nearest(const std::vector<PosedScan>& scans,
                                                const PosedScan& current) const
{
  std::optional<std::size_t> best;
  double bestNormalizedDistance = 0;
  for (const Keyframe& keyframe : keyframes_)
  {
    const PosedScan& reference = scans[keyframe.scan];
    const Pose2 T_keyframe_cur = seenFrom(reference, current);
    if (!policy_.isCandidate(T_keyframe_cur)) continue;
    const double normalizedDistance = policy_.normalizedDistance(T_keyframe_cur);
    if (best && normalizedDistance >= bestNormalizedDistance) continue;
    if (!isSeen(reference, current)) continue;
    best = keyframe.scan;
    bestNormalizedDistance = normalizedDistance;
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
  keyframes_.push_back({index, node});
  double linkInnovation_m = 0;
  for (const ReferenceMatch& link : links)
  {
    const auto from = nodeOf(link.reference);
    if (!from) continue;
    const PoseLink added{*from, node, link.T_ref_cur.pose, informationOf(link)};
    const Eigen::Vector3d error = linkError(added, graph_.poses()[*from], graph_.poses()[node]);
    linkInnovation_m =
        std::max(linkInnovation_m, error.head<2>().norm() + kLever_m * std::abs(error.z()));
    graph_.add(added);
  }
  if (linkInnovation_m > kGrossInnovation_m)
    optimise(scans, 0);
  else if (linkInnovation_m > kSmallInnovation_m)
    optimise(scans, node > kRecentNodes ? node - kRecentNodes : 0);
}

void KeyframeMap::optimise(std::vector<PosedScan>& scans) { optimise(scans, 0); }

void KeyframeMap::optimise(std::vector<PosedScan>& scans, std::size_t firstFree)
{
  graph_.optimise(firstFree);
  for (const Keyframe& keyframe : keyframes_)
    scans[keyframe.scan].T_world_robot.pose = graph_.poses()[keyframe.node];
}
}  // namespace psmks
