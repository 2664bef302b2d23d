/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>

namespace psmks
{
/** Proposes starts, refines them one after the other, and keeps the refined pose with the highest
 * posterior (RefinedPose::logPosterior). All that were associated well enough are left in
 * JointBuffers::refinedPoses. */
class CandidateSearch
{
 public:
  CandidateSearch(JointMatch& match, const PoseVerifier& verifier, Refinement& refinement)
      : match_(match), verifier_(verifier), refinement_(refinement)
  {
  }

  /** Reserves the memory that searches usually need. */
  void reserve();

  /** Refines a start and keeps the refined pose if it is the best so far. Where that is not
   * convincing (PoseVerifier) and scores lower than the start, it was associated with wrong lines,
   * such as the other face of a thin wall: the start is refined again with gates half as wide. */
  void refineAndKeep(const Pose2& start);

  /** Refines the poses that lines vote for (LineVotes), best rough score first, until one is
   * convincing (PoseVerifier). For a guess without a covariance it finds nothing that searchNear()
   * does not find, but most poses of rooms with walls in a third of its time; of one with a
   * covariance it looks beyond three standard deviations. */
  void followVotes();

  /** Refines the optima of CorrelativeSearch, best first, until one is convincing: within
   * JointOptions::searchRadius_m and searchAngle_rad of a guess without a covariance; within three
   * standard deviations, but no more than these, of one with a covariance. */
  void searchNear();

  /** As searchNear(), within JointOptions::wideRadius_m and wideAngle_rad of a guess without a
   *  covariance, twice as many optima.
   *
   *  A guess with a covariance is given up where it leaves no acceptable pose and a pose of this
   *  window is beyond doubt (PoseVerifier) without it. MatchResult::guessGivenUp says so, and
   *  from then on the match goes on as without a covariance. */
  void searchWide();

  /** Refines the guess and the optima of CorrelativeSearch within three standard deviations of it,
   * as many as in searchWide(), whether one of them is convincing or not. Without a covariance that
   * is the window of searchNear(). */
  void searchWithinCovariance();

  /** The refined pose with the highest posterior; its score is -1 where no start was associated
   * well enough. */
  const RefinedPose& best() const { return best_; }

  /** Associated rays of the refined pose that had most of them. */
  int mostAssociations() const { return mostAssociations_; }

 private:
  void keepIfBest(const RefinedPose& candidate);
  void search(const SearchWindow& window, std::size_t mostStarts);
  void proposeOptima(const SearchWindow& window, std::size_t mostStarts);
  void searchDespiteGuess();
  SearchWindow windowOfCovariance() const;
  SearchWindow nearWindow() const;
  SearchWindow wideWindow() const;
  std::size_t nearStarts() const;
  std::size_t farStarts() const;

  JointMatch& match_;
  const PoseVerifier& verifier_;
  Refinement& refinement_;
  RefinedPose best_;
  int mostAssociations_ = 0;
};
}  // namespace psmks
