/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/ReferencePolicy.h>

#include <cmath>

namespace psmks
{
namespace
{
bool isBeyond(const Pose2& T_ref_cur, double distance_m, double angle_rad)
{
  return T_ref_cur.translation().norm() >= distance_m || std::abs(T_ref_cur.phi_rad) >= angle_rad;
}
}  // namespace

void listFields(OptionTable& table, ReferenceOptions& o)
{
  table.beginSection("reference", "Which scan a new scan is matched against.");
  table.add(
      "choice", o.choice, {"sequential", "keyframe", "map"},
      "sequential: the last scan a trigger apart; keyframe: the same for as long as enough of "
      "it is seen; map: the nearest of all keyframes, which are matched against each other");
  table.add("match_every_scan", o.matchEveryScan,
            "false: scans nearer to the reference than the trigger go by odometry (the paper)");
  table.add(
      "trigger_distance_m", o.triggerDistance_m, Unit::Metre, 0, 100,
      "moved as far since the reference, a scan replaces it (sequential) or may do so (keyframe)");
  table.add(
      "trigger_angle_deg", o.triggerAngle_rad, Unit::Degree, 0, degToRad(180),
      "turned as far since the reference, a scan replaces it (sequential) or may do so (keyframe)");
  table.add("keyframe_distance_m", o.keyframeDistance_m, Unit::Metre, 0, 100,
            "keyframe: moved as far, a scan replaces the reference whatever they share");
  table.add("keyframe_angle_deg", o.keyframeAngle_rad, Unit::Degree, 0, degToRad(180),
            "keyframe: turned as far, a scan replaces the reference whatever they share");
  table.add("keyframe_min_rays", o.keyframeMinRays, 0, 100000,
            "keyframe: fewer associated rays, a trigger away, and the scan replaces the reference");
  table.add(
      "keyframe_min_score", o.keyframeMinScore, Unit::None, 0, 1,
      "keyframe: a smaller share of rays explained, a trigger away, and the scan replaces it");
  table.add("map_spacing_m", o.mapSpacing_m, Unit::Metre, 0, 100,
            "map: a scan as far from every keyframe becomes one");
  table.add("map_spacing_deg", o.mapSpacing_rad, Unit::Degree, 0, degToRad(180),
            "map: a scan turned as far from every keyframe becomes one");
  table.add("map_distance_m", o.mapDistance_m, Unit::Metre, 0, 100,
            "map: a keyframe farther away is no reference");
  table.add("map_angle_deg", o.mapAngle_rad, Unit::Degree, 0, degToRad(180),
            "map: a keyframe turned farther away is no reference");
  table.add("map_min_overlap", o.mapMinOverlap, Unit::None, 0, 1,
            "map: a keyframe that saw a smaller share of the scan is no reference");
  table.add("map_min_score", o.mapMinScore, Unit::None, 0, 1,
            "map: a match that explains a smaller share of rays does not tie keyframes");
  table.add(
      "map_drift_share", o.mapDriftShare, Unit::None, 0, 1,
      "map: of the way driven since a place was left, by which it may be off: so far away it is "
      "looked for; 0: only where it is expected");
  table.add("map_drift_per_metre_deg", o.mapDriftPerMetre_rad, Unit::Degree, 0, degToRad(10),
            "map: the same for the heading, for every metre");
  table.add("keyframe_window", o.keyframeWindow, 0, 1000,
            "keyframe: a new keyframe is matched against those around it among the last so many");
  table.add("map_links", o.mapLinks, 0, 1000,
            "map: a new keyframe is matched against as many of those around it");
  table.add(
      "retry_last_scan", o.retryLastScan,
      "a scan that fails against the reference is matched against the last matched scan, which "
      "becomes the reference; false: the paper");
  table.add("retry_score", o.retryScore, Unit::None, 0, 1,
            "the same for a match that explains a smaller share of rays, where the other explains "
            "more; 0: failures only");
  table.add("map_retry_score", o.mapRetryScore, Unit::None, 0, 1,
            "map: the same, where the last scan becomes one more keyframe");
  table.add("max_failures", o.maxFailures, 1, 1000000,
            "failed matches in a row after which the reference is given up");
}

bool ReferencePolicy::isTriggered(const Pose2& T_ref_cur) const
{
  return isBeyond(T_ref_cur, options_.triggerDistance_m, options_.triggerAngle_rad);
}

bool ReferencePolicy::isKeyframeLeft(const MatchResult& match, const Pose2& T_ref_cur) const
{
  const bool littleShared =
      match.associations < options_.keyframeMinRays || match.score < options_.keyframeMinScore;
  return isBeyond(T_ref_cur, options_.keyframeDistance_m, options_.keyframeAngle_rad) ||
         (littleShared && isTriggered(T_ref_cur));
}

bool ReferencePolicy::isCandidate(const Pose2& T_keyframe_cur) const
{
  return !isBeyond(T_keyframe_cur, options_.mapDistance_m, options_.mapAngle_rad);
}

double ReferencePolicy::normalizedDistance(const Pose2& T_keyframe_cur) const
{
  return T_keyframe_cur.translation().norm() / options_.mapDistance_m +
         std::abs(T_keyframe_cur.phi_rad) / options_.mapAngle_rad;
}

std::size_t ReferencePolicy::firstTied(std::size_t keyframes) const
{
  const auto window = static_cast<std::size_t>(options_.keyframeWindow);
  return usesMap() || keyframes < window ? 0 : keyframes - window;
}

Drift ReferencePolicy::driftAfter(double way_m) const
{
  return {options_.mapDriftShare * way_m, options_.mapDriftPerMetre_rad * way_m};
}

bool ReferencePolicy::isLoopCandidate(const Pose2& T_keyframe_cur, const Drift& drift) const
{
  constexpr double kKnown_m = 0.3;  // what overlap() forgives
  constexpr double kLost_m = 6;     // a search has to end somewhere
  const double reach_m = options_.mapSpacing_m + drift.displacement_m;
  const double reach_rad = options_.mapSpacing_rad + drift.rotation_rad;
  return drift.displacement_m > kKnown_m && drift.displacement_m < kLost_m &&
         !isBeyond(T_keyframe_cur, reach_m, reach_rad);
}

bool ReferencePolicy::isCovered(const Pose2& T_keyframe_cur) const
{
  return !isBeyond(T_keyframe_cur, options_.mapSpacing_m, options_.mapSpacing_rad);
}

bool ReferencePolicy::isMatched(const Pose2& T_ref_cur) const
{
  return options_.matchEveryScan || isTriggered(T_ref_cur);
}

bool ReferencePolicy::isRetried(const MatchResult& match) const
{
  const double enough = usesMap() ? options_.mapRetryScore : options_.retryScore;
  return options_.retryLastScan && (!match.usable() || match.score < enough);
}

bool ReferencePolicy::isBetter(const MatchResult& toLast, const MatchResult& toReference) const
{
  constexpr double kClearly = 0.05;  // more of the rays
  return toLast.status == MatchStatus::Converged && toLast.score > toReference.score + kClearly;
}

bool ReferencePolicy::isReplaced(const MatchResult& match, const Pose2& T_ref_cur,
                                 int failuresInARow) const
{
  if (!match.usable()) return failuresInARow >= options_.maxFailures;
  return options_.choice == ReferenceChoice::Sequential ? isTriggered(T_ref_cur)
                                                        : isKeyframeLeft(match, T_ref_cur);
}
}  // namespace psmks
