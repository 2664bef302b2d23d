/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>
#include <psmks/slam/PoseGraph.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace psmks
{
/** The scans that other scans are matched against, and the matches between them, which fix where
 * they are. ReferenceChoice::Map and ReferenceChoice::Keyframe keep one, and Sequential keeps none.
 *
 *        k3 ----- k2 -----.            A keyframe is matched, when it joins, against those around
 *        |  \   /  |       k1          it that saw the same things. These matches are the links of
 *        k4 --- k5 -----'              a graph of poses; a loop that closes moves all of them.
 *
 * With ReferenceChoice::Keyframe places are not recognised: one keyframe is the reference for as
 * long as ReferencePolicy says, so that TrajectoryBuilder calls neither nearest() nor covers() nor
 * possiblePlaces(), and around() asks the last few keyframes only.
 *
 * Keyframes are named by the indices of their scans in a trajectory. The caller passes the same
 * trajectory in every call, and the map keeps the poses of its keyframes up to date. */
class KeyframeMap
{
 public:
  explicit KeyframeMap(const ReferencePolicy& policy) : policy_(policy) {}

  /** A keyframe that may have seen what a scan shows, and the pose at which it is expected to. */
  struct ExpectedKeyframe
  {
    std::size_t keyframe = 0;  //!< index of its scan
    Pose2 T_keyframe_cur;      //!< where the robot at the scan would be, seen from the keyframe's
  };

  /** Tells from where the current scan is known. All other functions are about that scan, and ask
   * only keyframes of which the graph knows, seen from there, well enough where they are
   * (ReferencePolicy::isKnown()). A place that no loop ties to the present one yet, at the end of a
   * long way, is but a place to search a loop at (UncertainKeyframe).
   *  @param keyframe it placed the scan; ignored where it is none
   *  @param T_keyframe_cur the robot at the current scan */
  void standAt(std::size_t keyframe, const UncertainPose& T_keyframe_cur);

  /** The nearest keyframe within reach that saw enough of a scan, the pose of the scan being taken
   * for right. Nearness is ReferencePolicy::normalizedDistance(), of position and heading.
   *  @return none where no keyframe did */
  std::optional<std::size_t> nearest(const std::vector<PosedScan>& scans,
                                     const PosedScan& current) const;

  /** The keyframes within reach that saw enough of a scan, the nearest first. With
   * ReferenceChoice::Keyframe only the last ones are asked, ReferenceOptions::keyframeWindow many.
   */
  std::vector<ExpectedKeyframe> around(const std::vector<PosedScan>& scans,
                                       const PosedScan& current) const;

  /** A keyframe near which the current scan may be. */
  struct UncertainKeyframe
  {
    std::size_t keyframe = 0;
    UncertainPose T_keyframe_cur;  //!< where the graph expects the robot, seen from the keyframe's
  };

  /** The keyframes near which the current scan may be as far as the graph knows, within
   * ReferencePolicy::loopReach_m(), without being known to be: where the robot may have come back
   * to. */
  std::vector<UncertainKeyframe> possiblePlaces() const;

  /** The scans that together show the surroundings of a keyframe, its own first: the nearest 15 of
   * the keyframes that fit it, which are those on paths of links that leave at most so
   * much open as PoseGraph::known() counts it. */
  std::vector<std::size_t> localMap(std::size_t keyframe, double mostOpen_m) const;

  /** Whether a keyframe near a scan saw enough of it, so that the scan need not become one. */
  bool covers(const std::vector<PosedScan>& scans, const PosedScan& current) const;

  /** Adds the scan with this index as a keyframe at its present pose. Where a link contradicts
   * the poses by more than 1 cm, a heading error counted at a distance of 2 m, the poses of the
   * last keyframes are optimised, and those of all keyframes where it is more than 5 cm. A smaller
   * contradiction waits for the next link or for optimise().
   *  @param index greater than those of all keyframes so far
   *  @param links poses of the scan seen from other scans; those from scans that are no keyframes
   * are left out */
  void add(std::vector<PosedScan>& scans, std::size_t index,
           const std::vector<ReferenceMatch>& links);

  /** Moves all keyframes to where all links together say that they are. The first one stays. */
  void optimise(std::vector<PosedScan>& scans);

  /** The keyframes as nodes, in the order in which they were added, and the links between them. */
  const PoseGraph& graph() const { return graph_; }

  /** The index of the scan of every node. */
  const std::vector<std::size_t>& scansOfNodes() const { return scanOf_; }

 private:
  bool sawEnough(const PosedScan& keyframe, const PosedScan& current) const;
  bool isKnown(const PoseGraph::KnownNode& keyframe) const;
  UncertainPose expectedFrom(const PoseGraph::KnownNode& keyframe) const;
  std::optional<std::size_t> nodeOf(std::size_t scan) const;
  double addLink(const ReferenceMatch& link, std::size_t from, std::size_t to);
  void optimise(std::vector<PosedScan>& scans, std::size_t firstFree);

  ReferencePolicy policy_;
  PoseGraph graph_;
  std::vector<std::size_t> scanOf_;  //!< of every node of the graph, in ascending order
  std::size_t standingAt_ = 0;       //!< node of the keyframe from which the current scan is known
  UncertainPose T_standing_cur_;     //!< the robot at the current scan, seen from there
  std::vector<PoseGraph::KnownNode> near_;  //!< that may be known, seen from there, in their order
  std::size_t linksThen_ = 0;               //!< links that the graph had when these were sought
};
}  // namespace psmks
