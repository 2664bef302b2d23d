/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>
#include <psmks/match/MatchResult.h>

namespace psmks
{
/** Which scan a new scan is matched against. */
enum class ReferenceChoice
{
  Sequential,  //!< the last matched scan from which the robot had moved or turned far enough
               //!< (paper)
  Keyframe,    //!< the same scan for as long as enough of it is still seen
  Map          //!< the nearest of all keyframes, which are matched against each other
};

/** How far a pose may be off. */
struct Drift
{
  double displacement_m = 0;
  double rotation_rad = 0;
};

struct ReferenceOptions
{
  ReferenceChoice choice = ReferenceChoice::Map;
  bool matchEveryScan = true;              //!< false: only scans a trigger away (paper)
  double triggerDistance_m = 0.80;         //!< sequential, and the least of keyframe
  double triggerAngle_rad = degToRad(20);  //!< sequential, and the least of keyframe
  double keyframeDistance_m = 2.0;
  double keyframeAngle_rad = degToRad(40);
  int keyframeMinRays = 30;        //!< associated
  double keyframeMinScore = 0.50;  //!< MatchResult::score
  double mapSpacing_m = 1.0;
  double mapSpacing_rad = degToRad(30);
  double mapDistance_m = 4.0;
  double mapAngle_rad = degToRad(60);
  double mapMinOverlap = 0.5;   //!< see overlap()
  double mapMinScore = 0.8;     //!< MatchResult::score of a match that ties keyframes
  double mapDriftShare = 0.03;  //!< of the way driven, by which a place may be off
  double mapDriftPerMetre_rad = degToRad(0.1);
  int keyframeWindow = 20;      //!< a new keyframe is tied to one of the last so many
  int mapLinks = 6;             //!< matches that tie a new keyframe to those around it
  bool retryLastScan = true;    //!< after a failure, against the last scan that matched
  double retryScore = 0.94;     //!< the same after a match with a lower MatchResult::score
  double mapRetryScore = 0.85;  //!< the same with a map, where it makes one more keyframe
  int maxFailures = 5;          //!< in a row, then the reference is given up
};

void listFields(OptionTable& table, ReferenceOptions& options);

/** Decides when a scan is matched, and when it takes the place of the reference.
 *
 * Sequential, with every scan matched (o) or, as in the paper, only those that replace it (x):
 *
 *     reference ---o----o----x = new reference ---o---- ...
 *               <-- trigger ->
 *
 * A scan whose match fails may be matched once more against the scan before, which shares more with
 * it and takes the place of the reference. Apart from that a failure replaces nothing (the paper):
 * the reference waits for the next scan, until max_failures of them in a row have failed. */
class ReferencePolicy
{
 public:
  explicit ReferencePolicy(const ReferenceOptions& options) : options_(options) {}

  /** Whether a scan at this guessed pose, seen from the reference, is matched at all. */
  bool isMatched(const Pose2& T_ref_cur) const;

  /** Whether a scan that was matched like this is matched against the scan before, too. */
  bool isRetried(const MatchResult& match) const;

  /** Whether a match against the scan before takes the place of a usable one against the reference:
   * it adds one more error to those on the way to the reference. */
  bool isBetter(const MatchResult& toLast, const MatchResult& toReference) const;

  /** Map: whether a keyframe at this guessed pose may serve as the reference of a scan. */
  bool isCandidate(const Pose2& T_keyframe_cur) const;

  /** Map: how far a candidate is, 0 = at the same place, 2 = at the limits of place and heading. */
  double normalizedDistance(const Pose2& T_keyframe_cur) const;

  /** Map: whether a match is good enough to tie two keyframes: nothing forces it to be used. */
  bool isLink(const MatchResult& match) const
  {
    return match.usable() && match.score >= options_.mapMinScore;
  }

  /** Map: how many matches tie a new keyframe to others besides the one that made it. */
  std::size_t maxLinks() const { return static_cast<std::size_t>(options_.mapLinks); }

  /** Map: whether a keyframe makes another one at this pose of a scan unnecessary. */
  bool isCovered(const Pose2& T_keyframe_cur) const;

  /** Whether so much of a scan is seen by a keyframe that it can serve as the reference. */
  bool isEnough(double overlap) const { return overlap >= options_.mapMinOverlap; }

  bool usesMap() const { return options_.choice == ReferenceChoice::Map; }

  /** Keyframe and map: matches tie every reference to others. */
  bool tiesReferences() const { return options_.choice != ReferenceChoice::Sequential; }

  /** Of so many keyframes the first one that a new one may be tied to: all of a map, else the last
   * few. */
  std::size_t firstTied(std::size_t keyframes) const;

  /** Map: how far a place may be off after such a way. */
  Drift driftAfter(double way_m) const;

  /** Map: whether a keyframe may be a candidate for a scan, its place being known so badly that it
   * has to be searched for. */
  bool isLoopCandidate(const Pose2& T_keyframe_cur, const Drift& drift) const;

  /** Whether a scan becomes the reference after its match.
   *  @param failuresInARow matches that failed against this reference, this one included */
  bool isReplaced(const MatchResult& match, const Pose2& T_ref_cur, int failuresInARow) const;

 private:
  bool isTriggered(const Pose2& T_ref_cur) const;
  bool isKeyframeLeft(const MatchResult& match, const Pose2& T_ref_cur) const;

  ReferenceOptions options_;
};
}  // namespace psmks
