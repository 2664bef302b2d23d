/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/UncertainPose.h>
#include <psmks/match/MatchResult.h>

#include <Eigen/Core>
#include <cstddef>

namespace psmks
{
/** Which scan a new scan is matched against. */
enum class ReferenceChoice
{
  Sequential,  //!< the last matched scan from which the robot had moved or turned far enough
               //!< (paper)
  Keyframe,    //!< the same scan for as long as enough of it is still seen; keyframes are linked to
               //!< the last few
  Map          //!< the nearest of all keyframes, which are linked to each other
};

/** When scans are matched, what they are matched against, and what links keyframes. The section
 * `[reference]` of the option files describes each field; see listFields(). */
struct ReferenceOptions
{
  ReferenceChoice choice = ReferenceChoice::Map;
  bool matchEveryScan = true;               //!< false: only scans a trigger away (paper)
  double triggerDistance_m = 0.80;          //!< sequential, and the least of keyframe
  double triggerAngle_rad = degToRad(20);   //!< sequential, and the least of keyframe
  double keyframeDistance_m = 2.0;          //!< keyframe: replaced at the latest, moved so far
  double keyframeAngle_rad = degToRad(40);  //!< keyframe: replaced at the latest, turned so far
  int keyframeMinRays = 30;                 //!< compared with MatchResult::associations
  double keyframeMinScore = 0.30;           //!< compared with MatchResult::score
  double mapSpacing_m = 1.0;                //!< map: no new keyframe within this of one ...
  double mapSpacing_rad = degToRad(30);     //!< ... and within this
  double mapDistance_m = 4.0;          //!< map and keyframe: keyframes within this are tried ...
  double mapAngle_rad = degToRad(60);  //!< ... and within this
  double mapMinOverlap = 0.5;          //!< map and keyframe: compared with overlap()
  double mapMinScore = 0.6;            //!< map and keyframe: least MatchResult::score of a link
  int loopPlaces = 8;       //!< map: most places searched for each new keyframe, to close a loop
  int keyframeWindow = 20;  //!< keyframe: a new keyframe is linked to some of the last so many
  int mapLinks = 6;  //!< map and keyframe: most matches that link a new one to those around it
  double linkSigma_m = 0.005;            //!< added to each link, see linkInformation()
  double linkSigma_rad = degToRad(0.1);  //!< added to each link, see linkInformation()
  bool retryLastScan = true;   //!< after a failure, match against the scan before, and if that
                               //!< fails, too, with a wide prior; false: neither of them
  double retryScore = 0.9;     //!< a lower MatchResult::score also calls for the scan before
  double mapRetryScore = 0.7;  //!< the same with a map, where it makes one more keyframe
  int maxFailures = 5;         //!< in a row, then the reference is given up
};

/** Adds the section `[reference]` with every field of the options. */
void listFields(OptionTable& table, ReferenceOptions& options);

/** Decides when a scan is matched, which scans may serve as its reference, and when it becomes the
 * reference itself. It decides by the options and the arguments alone, and keeps no state.
 *
 * Sequential, with every scan matched (o) or, as in the paper, only those that replace the
 * reference (x):
 *
 *     reference ---o----o----x = new reference ---o---- ...
 *               <-- trigger ->
 *
 * A scan whose match fails may be matched once more against the scan before, which shares more with
 * it and becomes the reference. Apart from that a failure replaces nothing (paper): the reference
 * waits for the next scan, until as many matches in a row have failed as the option `max_failures`
 * says. */
class ReferencePolicy
{
 public:
  explicit ReferencePolicy(const ReferenceOptions& options) : options_(options) {}

  bool usesMap() const { return options_.choice == ReferenceChoice::Map; }

  /** Whether matches link the references to each other: keyframe and map. */
  bool linksReferences() const { return options_.choice != ReferenceChoice::Sequential; }

  /** Whether a scan that is expected at this pose is matched at all, or placed by odometry. */
  bool needsMatch(const Pose2& T_ref_cur) const;

  /** Whether a scan that was matched like this is matched in other ways, too: the match failed or
   * explains too little of the scan, and the options allow another try. */
  bool needsRetry(const MatchResult& match) const;

  /** Whether a match against the scan before is so much better than a usable one against the
   * reference that it decides. It has to be clearly better, for it adds one more error to those on
   * the way to the reference: converged, and with 5 % more of the rays explained. */
  bool isBetter(const MatchResult& toLast, const MatchResult& toReference) const;

  /** Without a map, or where the match failed: whether the scan becomes the reference.
   *  @param match the one that decides where the scan is
   *  @param T_ref_cur the pose of the scan
   *  @param failuresInARow scans in a row that failed against this reference, this one included */
  bool replacesReference(const MatchResult& match, const Pose2& T_ref_cur,
                         int failuresInARow) const;

  /** Whether a keyframe is near enough to a scan, in position and heading, to be its reference. */
  bool isWithinReach(const Pose2& T_keyframe_cur) const;

  /** How far a keyframe is: distance and angle in shares of their limits in isWithinReach(), added.
   * 0 at the same pose, less than 2 within reach. */
  double normalizedDistance(const Pose2& T_keyframe_cur) const;

  /** Whether a keyframe saw enough of a scan to be its reference; see overlap(). */
  bool overlapsEnough(double overlap) const { return overlap >= options_.mapMinOverlap; }

  /** Whether a keyframe as near as this makes another one at the pose of the scan unnecessary. */
  bool isCovered(const Pose2& T_keyframe_cur) const;

  /** Whether a pose is known well enough for a match to start there: to a standard deviation of 0.1
   * m and 1.5 degrees, three of which are what overlap() forgives. */
  bool isKnown(const Eigen::Matrix3d& covariance) const;

  /** What a path of links may leave open, as leftOpen_m() counts it, for a pose at its end to be
   * known: twice the limits of isKnown(), for errors of a heading and of a position may cancel. */
  double mostOpen_m() const;

  /** How far a robot may be from a keyframe and still see what it saw, after an error of three
   * standard deviations: the distance within which a keyframe is a place to search for a loop. */
  double loopReach_m(const Eigen::Matrix3d& covariance) const;

  /** Most places that are searched for a new keyframe. */
  std::size_t loopPlaces() const { return static_cast<std::size_t>(options_.loopPlaces); }

  /** How many matches link a new keyframe to others at most, besides the one that placed it. The
   * same number again is allowed for loop candidates. */
  std::size_t maxLinks() const { return static_cast<std::size_t>(options_.mapLinks); }

  /** The first of so many keyframes that a new one may be linked to. With a map that is the very
   * first, else the first of the last few. */
  std::size_t firstLinkable(std::size_t keyframes) const;

  /** Whether a match is good enough to link two keyframes. Nothing forces its use, so it has to
   * explain more of the scan than a match that places a scan. */
  bool isLink(const MatchResult& match) const
  {
    return match.usable() && match.score >= options_.mapMinScore;
  }

  /** The information that a link counts with: that of its match, its errors widened by the standard
   * deviations of the options `link_sigma_m` and `link_sigma_deg`. A match counts the noise of the
   * ranges alone. People, glass, and things that are not upright move it by more.
   *  @param ofMatch positive semidefinite; directions that it does not know stay unknown */
  Eigen::Matrix3d linkInformation(const Eigen::Matrix3d& ofMatch) const;

 private:
  bool isTriggered(const Pose2& T_ref_cur) const;
  bool isKeyframeLeft(const MatchResult& match, const Pose2& T_ref_cur) const;

  ReferenceOptions options_;
};
}  // namespace psmks
