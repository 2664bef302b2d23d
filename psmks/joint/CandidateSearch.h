/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>
#include <psmks/joint/WeakDirectionSearch.h>

namespace psmks
{
/** Proposes starts, refines them one after the other, and keeps the refined pose with the highest
 * ranking score. All that were associated well enough are left in JointBuffers::refinedPoses. */
class CandidateSearch
{
 public:
  CandidateSearch(JointMatch& match, const PoseVerifier& verifier, Refinement& refinement)
      : match_(match),
        verifier_(verifier),
        refinement_(refinement),
        hypothesisScore_(match.scores, match.guess.T_ref_cur, match.options)
  {
  }

  /** Reserves the memory of the widest search for a guess of this kind, so that no search of this
   * match allocates. */
  void reserve();

  /** Refines a start and keeps the refined pose if it is the best so far. Up to two refinements
   *  more, with the first gates half as wide, are kept in the same way:
   *
   *  - of the refined pose turned to its best line pair, where these two lines are left at an angle
   *    that chance does not explain (RefinedPose::bestPairAngleResidual_rad);
   *  - of the start, where the refined pose is not convincing (PoseVerifier) and scores lower than
   *    the start: it was associated with wrong lines, such as the other face of a thin wall. */
  void refineAndKeep(const Pose2& start);

  /** Refines the poses that segment angles and line intersections vote for, then, unless the guess
   *  is used as a measurement, places along walls where the best pose associates more than a
   *  quarter of the rays; both in descending order of their scores, until a pose is convincing
   *  (PoseVerifier). */
  void searchFurther();

  /** Refines the best poses of a grid (CorrelativeSearch). About a guess without a covariance the
   *  grid covers JointOptions::wideRadius_m and wideAngle_rad; about one with a covariance three
   *  standard deviations, at most searchRadius_m and searchAngle_rad. Such a pose replaces an
   *  acceptable one that was found before only where it explains a tenth more of the rays, for
   *  rooms look alike from many sides.
   *
   *  Where a guess with a covariance leaves no acceptable pose it is given up: the grid covers
   *  searchRadius_m and wideAngle_rad, and a pose that is beyond doubt (PoseVerifier) is kept.
   *  MatchResult::guessGivenUp says so, and from then on the match goes on as without a
   *  covariance, except that probeAlternatives() is not called. */
  void searchWide();

  /** Refines starts 20 cm beside the best pose, to either side along the direction that is known
   * worst, and at other promising places along it. They end at the best pose again, or they are
   * alternatives that JointConclusion finds among the refined poses. */
  void probeAlternatives();

  /** The refined pose with the highest ranking score; its own score is -1 where no start was
   * associated well enough. */
  const RefinedPose& best() const { return best_; }

  /** Associated rays of the refined pose that had most of them. */
  int mostAssociations() const { return mostAssociations_; }

 private:
  struct SearchWindow
  {
    CorrelativeLimits limits;
    int refinementBudgetFactor;  //!< times JointOptions::refinedHypotheses: most refined starts
  };

  void keepIfBest(const RefinedPose& candidate);
  static Pose2 rotatedToBestLinePair(const RefinedPose& candidate);
  void propose(const SearchLimits& limits);
  void refineBest(int maxStarts);
  void searchDespiteGuess();
  void tryGrid(const SearchWindow& window);
  SearchWindow withinGuess() const;
  SearchWindow farFromGuess() const;
  SearchWindow turnedFromGuess() const;
  SearchWindow exhaustiveWindow(double radius_m) const;
  void searchAlongWeakDirections();
  void searchAlong(const Eigen::Vector2d& direction);
  void proposeAlong(const Eigen::Vector2d& direction, const AlongLimits& limits);
  AlongLimits nearAlong() const;
  AlongLimits farAlong() const;

  JointMatch& match_;
  const PoseVerifier& verifier_;
  Refinement& refinement_;
  HypothesisScore hypothesisScore_;
  RefinedPose best_;
  int mostAssociations_ = 0;
};
}  // namespace psmks
