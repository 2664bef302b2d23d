/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/PoseGraph.h>
#include <psmks/slam/ReferencePolicy.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
namespace
{
/** Standard deviations up to which a match may start at a pose. Evidence: three of them are what
 * overlap() forgives at 4 m. */
constexpr double kKnown_m = 0.1, kKnown_rad = degToRad(1.5);

/** Standard deviation of a position along the direction that is known worst. */
double positionSigma_m(const Eigen::Matrix3d& covariance)
{
  const double mean_m2 = (covariance(0, 0) + covariance(1, 1)) / 2;
  const double halfDifference_m2 = (covariance(0, 0) - covariance(1, 1)) / 2;
  return std::sqrt(mean_m2 + std::hypot(halfDifference_m2, covariance(0, 1)));
}

/** Whether a pose is at least as far away, or turned at least as far, as the limits. */
bool isBeyond(const Pose2& T_ref_cur, double distance_m, double angle_rad)
{
  return T_ref_cur.translation().norm() >= distance_m || std::abs(T_ref_cur.phi_rad) >= angle_rad;
}

void listKeyframeFields(OptionTable& table, ReferenceOptions& o)
{
  table.add("keyframe_distance_m", o.keyframeDistance_m, Unit::Metre, 0, 100,
            "keyframe: a scan that has moved as far replaces the reference, whatever they share");
  table.add("keyframe_angle_deg", o.keyframeAngle_rad, Unit::Degree, 0, degToRad(180),
            "keyframe: a scan that has turned as far replaces the reference, whatever they share");
  table.add("keyframe_min_rays", o.keyframeMinRays, 0, 100000,
            "keyframe: a scan a trigger away replaces the reference where fewer rays are "
            "associated");
  table.add("keyframe_min_score", o.keyframeMinScore, Unit::None, 0, 1,
            "keyframe: a scan a trigger away replaces the reference where a smaller share of its "
            "rays is explained");
}

void listMapFields(OptionTable& table, ReferenceOptions& o)
{
  table.add("map_spacing_m", o.mapSpacing_m, Unit::Metre, 0, 100,
            "map: a scan as far from every keyframe becomes a keyframe");
  table.add("map_spacing_deg", o.mapSpacing_rad, Unit::Degree, 0, degToRad(180),
            "map: a scan turned as far from every keyframe becomes a keyframe");
  table.add(
      "map_distance_m", o.mapDistance_m, Unit::Metre, 0, 100,
      "map and keyframe: a keyframe farther away from a scan is neither its reference nor linked "
      "to it");
  table.add(
      "map_angle_deg", o.mapAngle_rad, Unit::Degree, 0, degToRad(180),
      "map and keyframe: a keyframe turned farther away from a scan is neither its reference nor "
      "linked to it");
  table.add(
      "map_min_overlap", o.mapMinOverlap, Unit::None, 0, 1,
      "map and keyframe: a keyframe that saw a smaller share of a scan is neither its reference "
      "nor linked to it");
  table.add("map_min_score", o.mapMinScore, Unit::None, 0, 1,
            "map and keyframe: a match that explains a smaller share of rays does not link "
            "keyframes");
  table.add(
      "loop_places", o.loopPlaces, 0, 1000,
      "map: for each new keyframe at most so many places are searched that the robot may have "
      "come back to; 0: no loop is closed");
}

void listLinkFields(OptionTable& table, ReferenceOptions& o)
{
  table.add("keyframe_window", o.keyframeWindow, 0, 1000,
            "keyframe: a new keyframe is matched against those around it among the last so many");
  table.add("map_links", o.mapLinks, 0, 1000,
            "map and keyframe: a new keyframe is matched against at most so many keyframes around "
            "it, and with a map against as many of earlier visits");
  table.add("link_sigma_m", o.linkSigma_m, Unit::Metre, 0, 1,
            "map and keyframe: standard deviation added to the position of every match that links "
            "keyframes, for errors that its covariance does not count: people, glass, things that "
            "are not upright");
  table.add("link_sigma_deg", o.linkSigma_rad, Unit::Degree, 0, degToRad(10),
            "map and keyframe: standard deviation added to the heading of every such match");
}

void listRetryFields(OptionTable& table, ReferenceOptions& o)
{
  table.add("retry_last_scan", o.retryLastScan,
            "a scan that fails against the reference is matched against the scan before, which "
            "becomes the reference, and if that fails, too, with a wide prior; false: neither of "
            "them (the paper)");
  table.add("retry_score", o.retryScore, Unit::None, 0, 1,
            "a scan of which a smaller share of rays is explained is matched against the scan "
            "before, too, and the better match counts; 0: only a scan that fails");
  table.add("map_retry_score", o.mapRetryScore, Unit::None, 0, 1,
            "map: takes the place of retry_score, for the scan before becomes one more keyframe");
  table.add("max_failures", o.maxFailures, 1, 1000000,
            "after as many failed matches in a row the reference is given up");
}
}  // namespace

void listFields(OptionTable& table, ReferenceOptions& o)
{
  table.beginSection("reference", "Which scan a new scan is matched against.");
  table.add("choice", o.choice, {"sequential", "keyframe", "map"},
            "sequential: the last scan a trigger apart; keyframe: the same scan for as long as "
            "enough of it is seen; map: the nearest of all keyframes, which are linked by matches "
            "against each other");
  table.add("match_every_scan", o.matchEveryScan,
            "false: a scan nearer to the reference than the trigger is placed by odometry (the "
            "paper)");
  table.add("trigger_distance_m", o.triggerDistance_m, Unit::Metre, 0, 100,
            "a scan that has moved as far since the reference replaces it (sequential) or may "
            "replace it (keyframe)");
  table.add("trigger_angle_deg", o.triggerAngle_rad, Unit::Degree, 0, degToRad(180),
            "a scan that has turned as far since the reference replaces it (sequential) or may "
            "replace it (keyframe)");
  listKeyframeFields(table, o);
  listMapFields(table, o);
  listLinkFields(table, o);
  listRetryFields(table, o);
}

bool ReferencePolicy::needsMatch(const Pose2& T_ref_cur) const
{
  return options_.matchEveryScan || isTriggered(T_ref_cur);
}

bool ReferencePolicy::needsRetry(const MatchResult& match) const
{
  const double enough = usesMap() ? options_.mapRetryScore : options_.retryScore;
  return options_.retryLastScan && (!match.usable() || match.score < enough);
}

bool ReferencePolicy::isBetter(const MatchResult& toLast, const MatchResult& toReference) const
{
  /** A match against the last scan is preferred where it explains so much more of the rays. Unit:
   * share of the rays. Evidence: measured. */
  constexpr double kClearly = 0.08;
  return toLast.status == MatchStatus::Converged && toLast.score > toReference.score + kClearly;
}

bool ReferencePolicy::replacesReference(const MatchResult& match, const Pose2& T_ref_cur,
                                        int failuresInARow) const
{
  if (!match.usable()) return failuresInARow >= options_.maxFailures;
  return options_.choice == ReferenceChoice::Sequential ? isTriggered(T_ref_cur)
                                                        : isKeyframeLeft(match, T_ref_cur);
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

bool ReferencePolicy::isWithinReach(const Pose2& T_keyframe_cur) const
{
  return !isBeyond(T_keyframe_cur, options_.mapDistance_m, options_.mapAngle_rad);
}

double ReferencePolicy::normalizedDistance(const Pose2& T_keyframe_cur) const
{
  return T_keyframe_cur.translation().norm() / options_.mapDistance_m +
         std::abs(T_keyframe_cur.phi_rad) / options_.mapAngle_rad;
}

bool ReferencePolicy::isCovered(const Pose2& T_keyframe_cur) const
{
  return !isBeyond(T_keyframe_cur, options_.mapSpacing_m, options_.mapSpacing_rad);
}

bool ReferencePolicy::isKnown(const Eigen::Matrix3d& covariance) const
{
  return positionSigma_m(covariance) <= kKnown_m && covariance(2, 2) <= kKnown_rad * kKnown_rad;
}

double ReferencePolicy::mostOpen_m() const
{
  const Eigen::Matrix3d mostKnown =
      Eigen::Vector3d(kKnown_m * kKnown_m, kKnown_m * kKnown_m, kKnown_rad * kKnown_rad)
          .asDiagonal();
  return 2 * leftOpen_m(mostKnown);
}

double ReferencePolicy::loopReach_m(const Eigen::Matrix3d& covariance) const
{
  /** Largest error that is reckoned with. Unit: standard deviations. Evidence: 99.7 % of normal
   * errors. */
  constexpr double kSigmas = 3;
  return options_.mapDistance_m + kSigmas * positionSigma_m(covariance);
}

std::size_t ReferencePolicy::firstLinkable(std::size_t keyframes) const
{
  const auto window = static_cast<std::size_t>(options_.keyframeWindow);
  return usesMap() || keyframes < window ? 0 : keyframes - window;
}

Eigen::Matrix3d ReferencePolicy::linkInformation(const Eigen::Matrix3d& ofMatch) const
{
  // (ofMatch^-1 + added)^-1 = ofMatch (I + added ofMatch)^-1, where ofMatch may be singular.
  const double sigma_m = options_.linkSigma_m, sigma_rad = options_.linkSigma_rad;
  const Eigen::Vector3d added(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad);
  const Eigen::Matrix3d widened =
      ofMatch * (Eigen::Matrix3d::Identity() + added.asDiagonal() * ofMatch).inverse();
  return (widened + widened.transpose()) / 2;
}
}  // namespace psmks
