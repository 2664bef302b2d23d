/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Innovation.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

namespace psmks
{
/** How a match ended.
 *
 * In every failure `T_ref_cur` is the guess (the identity where the guess is not finite), and the
 * covariance is that of the guess, or MatchResult::unknownCovariance() where the guess has none or
 * an invalid one. */
enum class MatchStatus
{
  /** No match was made: the result was constructed by default. Failure. */
  NotRun,

  /** The scans fix position and heading. The last step fell below `stopTranslation_m` and
   *  `stopRotation_rad` of the scheme's options (ini: `stop_translation_m`, `stop_rotation_deg`),
   *  or (paper) a further alternation would raise the matching error. Usable. Whether the guess
   *  agrees is another question: see MatchResult::contradictsGuess(). */
  Converged,

  /** As Converged, but `maxIterations` of the scheme's options (ini: `max_iterations`) ran out
   *  before the steps were that short. The pose is the best estimate so far. Usable. */
  MaxIterations,

  /** Fewer rays were associated than `minAssociations` of the scheme's options (ini:
   *  `min_associations`). Failure. */
  TooFewAssociations,

  /** Joint scheme: no pose that was tried reached JointOptions::acceptScore (ini:
   *  `joint.accept_score`), half of it where it agrees with a measured guess, or 0.15 more
   *  where it contradicts the guess. Paper's scheme: the matching error did not fall below that of
   *  the guess, or the residuals not to PaperOptions::maxResidual_m (ini: `paper.max_residual_m`).
   *  Failure. */
  NoImprovement,

  /** As Converged or MaxIterations, but the scans leave something open. At least one of
   *  `unobservableDirection`, `weakDirection`, `headingUnobservable` and `ambiguity` says what, and
   *  what pose and covariance mean there. Usable with its covariance. */
  Degenerate,

  /** A scan without a valid ray, a guess that is not finite, or a covariance of the guess that is
   *  not finite, not symmetric or not positive definite. Failure. */
  InvalidInput
};

/** "Converged", "Degenerate", ... */
const char* toString(MatchStatus status);

/** Wall time of the stages of a match. */
struct StageTimes
{
  double segmentation_s = 0;  //!< of the scans segmented inside the match
  double search_s = 0;        //!< orientation search (paper) or proposal of hypotheses (joint)
  double refinement_s = 0;    //!< translation regression (paper) or Gauss-Newton (joint)
  double scoring_s = 0;       //!< free-space score, observability, covariance

  double total_s() const { return segmentation_s + search_s + refinement_s + scoring_s; }
};

/** Other optima that explain the scans about as well as the reported pose. */
struct Ambiguity
{
  /** An optimum and its weight: its probability, if the right pose is among the reported one and
   * the alternatives, none of which counts as likelier than the reported one. */
  struct Alternative
  {
    Pose2 T_ref_cur;
    double weight = 0;
  };

  /** Most alternatives that are listed. Unit: poses. Definition: size of the array. */
  static constexpr int kMost = 4;

  int alternatives = 0;  //!< distinct optima besides the reported pose, each counted once
  std::array<Alternative, kMost> likeliest;  //!< the first of them, highest weight first
};

/** What a match found. */
struct MatchResult
{
  MatchStatus status = MatchStatus::NotRun;

  /** Pose of the current sensor frame in the reference sensor frame. */
  Pose2 T_ref_cur;

  /** Covariance of (x, y, phi) in the axes of the reference frame: m^2, m rad, rad^2. Positive
   *  definite. It is (P_guess^-1 + H)^-1, H the information of the scans at the pose and P_guess
   *  the covariance of the guess, or unknownCovariance() where it has none or was given up; the
   *  fields below say what they change of it. Errors of whole scans that the options state are
   *  added to all of that (WholeScanErrors.h). */
  Eigen::Matrix3d covariance = unknownCovariance();

  /** Lack of constraint, as along a bare corridor: unit vector u in the axes of the reference frame
   *  along which the scans do not fix the position. Set where the standard deviation of the
   *  position along its worst known direction, from the scans alone and with the heading estimated
   *  too, exceeds
   *
   *  - joint: JointOptions::unobservableSigma_m (ini: `joint.unobservable_sigma_m`),
   *    weakDirectionSigma_m and 1.5 times the standard deviation of a range;
   *  - paper: PaperOptions::weakDirectionSigma_m (ini: `paper.weak_direction_sigma_m`).
   *
   *  Along u the pose is exactly the guess and the variance exactly that of the guess: whatever the
   *  scans say about that component of the position is given up. Across u, and in the heading, both
   *  are the estimate. */
  std::optional<Eigen::Vector2d> unobservableDirection;

  /** Weak constraint, as along a corridor with a few door jambs: unit vector in the axes of the
   *  reference frame along which the scans fix the position badly. Set where the same standard
   *  deviation exceeds JointOptions::weakDirectionSigma_m (ini: `joint.weak_direction_sigma_m`) and
   *  1.5 times that of a range, and is too small for `unobservableDirection`. Pose and covariance
   *  are the estimate in all directions; the covariance shows how well this one is known. Joint
   *  scheme only. */
  std::optional<Eigen::Vector2d> weakDirection;

  /** True where the scans do not fix the heading, as in a round room. Set where its standard
   *  deviation, from the scans alone and with the position estimated too, exceeds
   *  `weakHeadingSigma_rad` of the scheme's options (ini: `weak_heading_sigma_deg`), or (joint)
   *  where all of the following hold:
   *
   *  - no pair of lines fixes its direction to 0.25 degrees;
   *  - another heading explains the scans as well: a start turned by 5 degrees ends more than
   *    `weakHeadingSigma_rad` away, and is at most 20 times less likely by the rays and the prior;
   *  - the heading of the guess explains them as well: a start turned to it ends at most 20 times
   *    less likely, too.
   *
   *  The heading is exactly that of the guess, with its variance, and the position the one that
   *  suits this heading. The variance of the heading carries over to the position. Position and
   *  heading are correlated accordingly. */
  bool headingUnobservable = false;

  /** Ambiguity between optima, as between equal doors: other poses explain the scans about as well.
   *  Joint scheme only, and among the poses that were tried: its absence proves nothing. An
   *  alternative is a refined pose that
   *
   *  - is at most 20 times (3 nat) less likely, by the rays (logLikelihoodRatio()) and the prior, a
   *    guess without a covariance counting as one with unknownCovariance();
   *  - lies more than 0.1 m or 2 degrees away, distances along `unobservableDirection` left out;
   *  - does not contradict the guess;
   *
   *  or a pose with another heading, where the first two conditions of the list under
   *  `headingUnobservable` hold and the third does not.
   *
   *  The pose is the likeliest optimum, not the guess, nor a mean. The covariance is the second
   *  moment of the mixture about it: an alternative d away in (x, y, phi) adds its weight times
   *  d d'. */
  std::optional<Ambiguity> ambiguity;

  /** How far the guess is from what the scans alone say. Set by the joint scheme where a usable
   *  result came from a guess with a covariance. What is taken from the guess does not count. */
  std::optional<Innovation> innovation;

  /** True where the guess left no acceptable pose and was given up (joint, SearchScope::Full): the
   *  pose is then what the scans alone say, as from a guess without a covariance, and
   *  contradictsGuess() tells the reason. */
  bool guessGivenUp = false;

  /** Free-space score of the best pose, 0 to 1: the share of what speaks for the pose in what
   * speaks for it and against it (freeSpaceScore()), 1 where all that the other scan could judge
   * lies on its surfaces, 1/2 where as much speaks against the pose as for it. In a failure that of
   * the best pose that was refused, or 0. */
  double score = 0;

  int associations = 0;  //!< associated rays of the pose that the score belongs to
  int iterations = 0;    //!< steps of the optimiser over the whole match: alternations of the
                         //!< paper's scheme, Gauss-Newton steps of the joint one
  int hypotheses = 0;    //!< joint scheme: starts that were refined; 0 in the paper's scheme
  StageTimes times;

  /** Matching error at the guess and after the match; no unit (paper, section 2.2). Only the
   *  paper's scheme has it: 0 in the joint scheme, which judges poses by the score. In a failure
   *  both are that of the guess. */
  double errorBefore = 0, errorAfter = 0;

  /** True where T_ref_cur may be used: Converged, MaxIterations or Degenerate. */
  bool usable() const;

  /** True where the guess had a covariance and the scans contradict it: the innovation lies outside
   *  the 99.9 % ellipsoid of P_guess + P_scans. One of the two covariances is then wrong, and with
   *  it the pose, which is the best compromise between both unless the guess was given up. */
  bool contradictsGuess() const;

  /** Unit vector from the position of the reported pose to that of the likeliest alternative; none
   *  without an ambiguity, or where only the headings differ. */
  std::optional<Eigen::Vector2d> ambiguousDirection() const;

  /** One line for people: status, pose, standard deviations, score, associations, iterations, time,
   *  and what is open or contradicts the guess. */
  std::string report() const;

  /** What stands for the covariance of a guess that has none: standard deviations of 1 m, 1 m and
   *  30 degrees. */
  static Eigen::Matrix3d unknownCovariance();
};
}  // namespace psmks
