/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PoseGraph.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

#include <optional>
#include <vector>

namespace psmks
{
/** The scans that others are matched against, and the matches between them that fix where they are.
 *
 *        k3 ----- k2 -----.            links: matches of a keyframe, when it joins, against those
 *        |  \   /  |       k1          around it that saw the same things. A loop that closes
 *        k4 --- k5 -----'              moves all of them.
 *
 * Keyframes are indices into the scans of a trajectory, whose poses the map keeps up to date. */
class KeyframeMap
{
 public:
  explicit KeyframeMap(const ReferencePolicy& policy) : policy_(policy) {}

  /** A keyframe that may have seen what a scan shows, and where it would have. */
  struct View
  {
    std::size_t keyframe = 0;
    Pose2 T_keyframe_cur;  //!< of the robots
  };

  /** The nearest keyframe that saw enough of a scan. */
  std::optional<std::size_t> nearest(const std::vector<PosedScan>& scans,
                                     const PosedScan& current) const;

  /** Keyframes that saw enough of a scan, the nearest first. */
  std::vector<View> around(const std::vector<PosedScan>& scans, const PosedScan& current) const;

  /** Keyframes of earlier visits that would have seen a scan if the way since then had drifted as
   * much as it may have, the one that shares most first. Each with the pose at which it shares
   * most.
   *  @param reference the keyframe that the scan hangs on: the way is that of the links from there
   */
  std::vector<View> loopCandidates(const std::vector<PosedScan>& scans, const PosedScan& current,
                                   std::size_t reference) const;

  /** Whether a scan shows nothing that a keyframe near it has not shown. */
  bool covers(const std::vector<PosedScan>& scans, const PosedScan& current) const;

  /** Takes in a scan at its present pose, with the measured poses of it in other keyframes, and
   * sets the poses of keyframes anew where these say something new. */
  void add(std::vector<PosedScan>& scans, std::size_t index,
           const std::vector<ReferenceMatch>& links);

  /** Sets the poses of all keyframes to what all links say together. */
  void optimise(std::vector<PosedScan>& scans);

 private:
  struct Keyframe
  {
    std::size_t scan;
    std::size_t node;
  };

  bool isSeen(const PosedScan& keyframe, const PosedScan& current) const;
  std::optional<std::size_t> nodeOf(std::size_t scan) const;
  void optimise(std::vector<PosedScan>& scans, std::size_t firstFree);

  ReferencePolicy policy_;
  PoseGraph graph_;
  std::vector<Keyframe> keyframes_;
};
}  // namespace psmks
