/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <optional>
#include <string>

namespace psmks
{
/** How a match ended. In every failure `T_ref_cur` is the guess and the covariance is that of the
 *  guess where one was given, else MatchResult::kUnknownCovariance. */
enum class MatchStatus
{
  NotRun,              //!< a default-constructed result: no match was made. Failure.
  Converged,           //!< the last step fell below the options' step limits, or (paper) a further
                       //!< alternation would raise the error. Pose: the estimate.
  MaxIterations,       //!< the iterations ran out first. Pose: the best estimate so far; usable.
  TooFewAssociations,  //!< fewer associated rays than `min_associations`. Failure.
  NoImprovement,       //!< paper: the matching error did not fall below that of the guess, or
                       //!< not to `max_residual_m`;
                       //!< joint: no pose tried reached the acceptance score. Failure.
  Degenerate,          //!< as Converged, but one direction is not observable (a corridor): along it
               //!< the pose is the guess, across it the estimate. Usable with its covariance.
  InvalidInput  //!< no valid ray in one of the scans, or a guess that is not finite or whose
                //!< covariance is not positive definite. Failure.
};

/** "Converged", "Degenerate", ... */
const char* toString(MatchStatus status);

/** Where the time of a match went. */
struct StageTimes
{
  double segmentation_s = 0;  //!< of the scans segmented inside the match
  double search_s = 0;        //!< orientation search or hypotheses
  double refinement_s = 0;    //!< translation regression or Gauss-Newton
  double scoring_s = 0;       //!< free-space score, observability, covariance

  double total_s() const { return segmentation_s + search_s + refinement_s + scoring_s; }
};

/** What a match found. */
struct MatchResult
{
  MatchStatus status = MatchStatus::NotRun;

  /** Pose of the current sensor frame in the reference sensor frame. */
  Pose2 T_ref_cur;

  /** Covariance of (x, y, phi) in the axes of the reference frame: m^2, m rad, rad^2. Never zero:
   *  (1 m)^2, (1 m)^2, (30 deg)^2 where nothing better is known. */
  Eigen::Matrix3d covariance = unknownCovariance();

  /** Unit vector in the reference frame along which the scans do not fix the position. */
  std::optional<Eigen::Vector2d> unobservableDirection;

  /** True where the scans do not fix the heading (a round room). */
  bool headingUnobservable = false;

  double errorBefore = 0;  //!< matching error at the guess; no unit. Paper: section 2.2; joint:
                           //!< 1 - free-space score
  double errorAfter = 0;   //!< matching error at T_ref_cur
  double score = 0;        //!< share of the rays explained by the other scan, 0 to 1
  int associations = 0;    //!< associated rays at T_ref_cur
  int iterations = 0;      //!< alternations (paper) or Gauss-Newton steps (joint)
  int hypotheses = 0;      //!< starts that were refined (joint)
  StageTimes times;

  /** True where T_ref_cur may be used: Converged, MaxIterations or Degenerate. */
  bool usable() const;

  /** One line for people: status, pose, sigmas, score, associations, iterations, time. */
  std::string report() const;

  static Eigen::Matrix3d unknownCovariance();
};
}  // namespace psmks
