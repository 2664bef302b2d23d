/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/KeyframeMap.h>
#include <psmks/slam/PosedScan.h>
#include <psmks/slam/PosedScanMatcher.h>
#include <psmks/slam/ReferencePolicy.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** Finds out whether a new keyframe shows a place that the robot has been to before, where the
 * graph of poses does not know.
 *
 * 1. The graph tells the places that the robot may be at, from its own covariances
 *    (KeyframeMap::possiblePlaces()). Those in sight and near are searched first, places at least 2
 *    m apart, and those that were searched in vain already come after all others: a robot that is
 *    lost has asked every place after some keyframes.
 * 2. The view that the latest keyframes give of the surroundings, all round, is matched against
 * that of the keyframes about the place (LocalView.h), anywhere within what the graph leaves open.
 * So a place is found from whatever side the robot comes. Where two poses explain the views about
 * as well the place is not taken.
 *    Where places that were searched for one scan disagree about the pose, none of them is taken.
 * 3. From the pose so found the scan itself is matched against the keyframes that saw the same.
 * Where none did, as on the way back along a corridor, the match of the views is the link. */
class LoopSearch
{
 public:
  explicit LoopSearch(const ReferencePolicy& policy) : policy_(policy) {}

  /** A place that a scan shows, and where the scan is then. */
  struct Recognised
  {
    ReferenceMatch match;  //!< of the views
    Pose2 T_world_cur;
    std::vector<std::size_t> members;  //!< scans of the place
  };

  /** Searches for the places of a scan that becomes a keyframe.
   *  @param map stands at the scan (KeyframeMap::standAt()), which is not part of it yet
   *  @param keyframe from which the scan is known, with T_keyframe_cur
   *  @return poses of the scan seen from keyframes of the map */
  std::vector<ReferenceMatch> links(const std::vector<PosedScan>& scans, std::size_t index,
                                    std::size_t keyframe, const UncertainPose& T_keyframe_cur,
                                    const KeyframeMap& map, PosedScanMatcher& matcher);

 private:
  using Place = KeyframeMap::UncertainKeyframe;

  /** A scan, what it shows together with the scans before it, and who links it. */
  struct Here
  {
    const std::vector<PosedScan>& scans;
    std::size_t index;
    std::vector<std::size_t> members;  //!< scans of the view
    Scan view;
    PosedScanMatcher& matcher;
  };

  std::vector<Place> choose(std::vector<Place> places, const Scan& view);
  double urgency(const Place& place, const Scan& view) const;
  void recognise(const Place& place, std::vector<std::size_t> members, Here& here,
                 std::vector<Recognised>& recognised) const;
  void linkTo(Recognised place, Here& here, std::vector<ReferenceMatch>& links) const;
  std::vector<ReferenceMatch> matchesAt(const Pose2& T_world_cur, std::vector<std::size_t> members,
                                        Here& here) const;

  ReferencePolicy policy_;
  std::vector<int> searches_;  //!< of every scan, how often its place was searched in vain
};
}  // namespace psmks
